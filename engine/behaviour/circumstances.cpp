#include "continua/behaviour/circumstances.h"

#include <utility>

#include "continua/facts/world_facts.h"
#include "continua/world/relations.h"

namespace continua {
namespace {

using Kind = Expression::Kind;

Term named(const std::string& name) { return Term::constant(name, Type::term()); }

Term applied(const std::string& function, const std::vector<Term>& arguments) {
  Term term = named(function);
  for (const auto& each : arguments) term = Term::apply(term, each);
  return term;
}

bool is_constant(const Term& term) { return term.kind() == Term::Kind::constant; }

// A place is wide unless the world alone shows that a thing was brought there, as for a point, `on`, `in` and `at`.
bool is_wide(const Term& place) {
  if (place.kind() == Term::Kind::place) return false;
  const auto [head, landmarks] = place.spine();
  const auto relation = is_constant(head) ? relation_named(head.name()) : std::nullopt;
  return relation && *relation != Relation::on && *relation != Relation::in && *relation != Relation::at;
}

}  // namespace

Term agent_term() { return Term::entity("avatar"); }

Term place_term(const ObjectState& object, const WorldSnapshot& world) {
  for (const auto relation : {Relation::in, Relation::on})
    for (const auto& other : world.objects) {
      const Landmark landmark = Landmark::object(other);
      if (holds_by(relation, object, {&landmark, 1}, world.table, Perspective::avatar) > 0)
        return applied(std::string(name_of(relation)), {Term::entity(other.name)});
    }
  return Term::point(object.p_WO.x(), object.p_WO.y(), world.table.max.z());
}

Term Circumstances::value(const Expression& expression, const Bindings& bindings) const {
  const auto bound = [&](const std::string& name) -> const Term* {
    const auto found = bindings.find(name);
    return found == bindings.end() ? nullptr : &found->second;
  };
  switch (expression.kind) {
    case Kind::name:
      if (const auto* found = bound(expression.name)) return *found;
      return Landmark::named(expression.name, world_) ? Term::entity(expression.name) : named(expression.name);
    case Kind::component:
      if (const auto* found = bound("[" + expression.name + "]")) return *found;
      return Term::null();
    case Kind::text:
      if (const auto* found = bound(expression.name)) return *found;
      return Term::text(expression.name);
    default:
      break;
  }
  std::vector<Term> arguments;
  for (const auto& each : expression.arguments) arguments.push_back(value(each, bindings));
  if (expression.kind == Kind::negation) return applied("not", arguments);
  if (expression.kind == Kind::both) return applied("and", arguments);
  if (expression.kind == Kind::either) return applied("or", arguments);
  if (expression.name == "loc" && arguments.size() == 1) {
    if (arguments[0].kind() == Term::Kind::place) return arguments[0];
    const auto* object = is_constant(arguments[0]) ? world_.find(arguments[0].name()) : nullptr;
    return object ? place_term(*object, world_) : Term::null();
  }
  return applied(expression.name, arguments);
}

std::optional<bool> Circumstances::hold(const Expression& condition, const Bindings& bindings) const {
  if (condition.kind == Kind::negation && condition.arguments.size() == 1) {
    const auto inner = hold(condition.arguments[0], bindings);
    return inner ? std::optional(!*inner) : std::nullopt;
  }
  if (condition.kind != Kind::both && condition.kind != Kind::either) return one_holds(condition, bindings);
  const bool decisive = condition.kind == Kind::either;
  std::optional<bool> all = !decisive;
  for (const auto& each : condition.arguments) {
    const auto inner = hold(each, bindings);
    if (inner == decisive) return decisive;
    if (!inner) all = std::nullopt;
  }
  return all;
}

std::optional<bool> Circumstances::one_holds(const Expression& condition, const Bindings& bindings) const {
  if (condition.kind != Kind::call || condition.arguments.empty()) return std::nullopt;
  std::vector<Term> arguments;
  for (const auto& each : condition.arguments) arguments.push_back(value(each, bindings));
  if (condition.name == "hold") {
    if (arguments.size() == 2 && !(arguments[0] == agent_term())) return false;
    return is_constant(arguments.back()) && world_.held == arguments.back().name() && !world_.held.empty();
  }
  std::string relation = condition.name;
  if (arguments.size() == 2 && (relation == "contain" || relation == "support")) {
    relation = name_of(relation == "contain" ? Relation::in : Relation::on);
    std::swap(arguments[0], arguments[1]);
  }
  if (!relation_named(relation) || arguments.size() < 2) return std::nullopt;
  const Term thing = arguments[0];
  arguments.erase(arguments.begin());
  // A place may be at(y, on(z)) or at(y, <0, 0, 0>) as well as at(y, z).
  const bool is_place = relation == name_of(Relation::at) && arguments.size() == 1 && !is_constant(arguments[0]);
  if (is_place && is_wide(arguments[0]) && is_constant(thing) && !brought_.contains(thing.name())) return false;
  return is_located(thing, is_place ? arguments[0] : applied(relation, arguments), world_, perspective_);
}

}  // namespace continua
