#include "continua/term/unify.h"

#include <map>

#include <fmt/format.h>

namespace continua {
namespace {

// Terms can be written whose types grow exponentially with the length of the term.
constexpr std::size_t most_unification_steps = 100000;

Type renewed(const Type& type, std::map<int, Type>& renewals, Unifier& unifier) {
  if (!type.polymorphic()) return type;
  switch (type.kind()) {
    case Type::Kind::base:
      return type;
    case Type::Kind::variable: {
      const auto found = renewals.find(type.index());
      return found != renewals.end() ? found->second : renewals.emplace(type.index(), unifier.fresh()).first->second;
    }
    case Type::Kind::list:
      return Type::list(renewed(type.element(), renewals, unifier));
    case Type::Kind::dot: {
      auto first = renewed(type.first(), renewals, unifier);
      return Type::dot(std::move(first), renewed(type.second(), renewals, unifier));
    }
    case Type::Kind::function: {
      auto from = renewed(type.from(), renewals, unifier);
      return Type::function(std::move(from), renewed(type.to(), renewals, unifier));
    }
  }
  return type;
}

}  // namespace

bool Unifier::gave_up() const { return steps_ > most_unification_steps; }

Type Unifier::fresh() {
  known_.emplace_back();
  return Type::variable(static_cast<int>(known_.size()) - 1);
}

Type Unifier::instance(const Type& type) {
  std::map<int, Type> renewals;
  return renewed(type, renewals, *this);
}

Type Unifier::known(const Type& type) const {
  Type at = type;
  while (at.kind() == Type::Kind::variable && known_[at.index()]) at = *known_[at.index()];
  return at;
}

bool Unifier::occurs(int variable, const Type& type) {
  if (!type.polymorphic()) return false;
  if (++steps_ > most_unification_steps) return true;
  const Type at = known(type);
  switch (at.kind()) {
    case Type::Kind::base:
      return false;
    case Type::Kind::variable:
      return at.index() == variable;
    case Type::Kind::list:
      return occurs(variable, at.element());
    case Type::Kind::dot:
      return occurs(variable, at.first()) || occurs(variable, at.second());
    case Type::Kind::function:
      return occurs(variable, at.from()) || occurs(variable, at.to());
  }
  return false;
}

bool Unifier::unify(const Type& a, const Type& b) {
  if (++steps_ > most_unification_steps) return false;
  const Type left = known(a), right = known(b);
  const bool left_unknown = left.kind() == Type::Kind::variable, right_unknown = right.kind() == Type::Kind::variable;
  if (left_unknown && right_unknown && left.index() == right.index()) return true;
  if (left_unknown || right_unknown) {
    const auto& unknown = left_unknown ? left : right;
    const auto& other = left_unknown ? right : left;
    if (occurs(unknown.index(), other)) return false;
    known_[unknown.index()] = other;
    return true;
  }
  if (left == Type::term() || right == Type::term()) return true;
  if (left.kind() != right.kind()) return false;
  switch (left.kind()) {
    case Type::Kind::list:
      return unify(left.element(), right.element());
    case Type::Kind::dot:
      return unify(left.first(), right.first()) && unify(left.second(), right.second());
    case Type::Kind::function:
      return unify(left.from(), right.from()) && unify(left.to(), right.to());
    default:
      return consistent(left, right);
  }
}

Type Unifier::resolved(const Type& type) {
  if (!type.polymorphic()) return type;
  if (++steps_ > most_unification_steps) return Type::term();
  const Type at = known(type);
  switch (at.kind()) {
    case Type::Kind::base:
      return at;
    case Type::Kind::variable:
      return Type::term();
    case Type::Kind::list:
      return Type::list(resolved(at.element()));
    case Type::Kind::dot:
      return Type::dot(resolved(at.first()), resolved(at.second()));
    case Type::Kind::function:
      return Type::function(resolved(at.from()), resolved(at.to()));
  }
  return at;
}

std::string Unifier::described(const Type& type) {
  const Type at = known(type);
  const auto unknown = [&](const Type& part) { return known(part).kind() == Type::Kind::variable; };
  switch (at.kind()) {
    case Type::Kind::base:
      return at.name();
    case Type::Kind::variable:
      return "anything";
    case Type::Kind::list:
      return unknown(at.element()) ? "a list" : resolved(at).text();
    case Type::Kind::dot:
      return resolved(at).text();
    case Type::Kind::function: {
      std::string text = "a function";
      if (!unknown(at.from())) text += " from " + resolved(at.from()).text();
      if (!unknown(at.to())) text += " to " + resolved(at.to()).text();
      return text;
    }
  }
  return {};
}

std::optional<Type> result_type(const Type& function, const Type& argument) {
  if (function == Type::term() || function.kind() == Type::Kind::variable) return Type::term();
  if (function.kind() != Type::Kind::function) return std::nullopt;
  if (!function.polymorphic())
    return consistent(function.from(), argument) ? std::optional(function.to()) : std::nullopt;
  Unifier unifier;
  const Type own = unifier.instance(function);
  if (!unifier.unify(own.from(), unifier.instance(argument)) && !unifier.gave_up()) return std::nullopt;
  return unifier.resolved(own.to());
}

}  // namespace continua
