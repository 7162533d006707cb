#include "continua/term/term.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <variant>

#include "continua/term/unify.h"

namespace continua {
namespace {

constexpr std::size_t largest_size = std::size_t{1} << 32;

std::size_t saturated(std::size_t size) { return std::min(size, largest_size); }

struct Binder {
  std::string hint;
  Type variable;
  Term body;
};
struct Pair {
  Term function, argument;
};

}  // namespace

// The null term has no node at all, so that making one costs nothing.
struct TermNode {
  Term::Kind kind;
  Type type;
  std::variant<bool, double, std::string, Place, int, Name, Binder, Pair, std::vector<Term>> held;
  TermDigest digest;
  int reach = 0;
  std::size_t depth = 1;
  std::size_t size = 1;
};

namespace {

// The numbers of Term::Kind are part of every digest.
TermDigester digester(Term::Kind kind) { return TermDigester(static_cast<std::uint64_t>(kind)); }

TermDigest digest_of(Term::Kind kind, std::uint64_t word) {
  auto all = digester(kind);
  all.add(word, 0);
  return all.digest();
}

TermDigest digest_of(Term::Kind kind, std::string_view bytes) {
  auto all = digester(kind);
  all.add(bytes);
  return all.digest();
}

TermDigest digest_of(const Place& place) {
  auto all = digester(Term::Kind::place);
  all.add(place.region ? 1 : 0, 0);
  for (std::size_t i = 0; i < 3; ++i)
    all.add(std::bit_cast<std::uint64_t>(place.min[i]), std::bit_cast<std::uint64_t>(place.max[i]));
  return all.digest();
}

}  // namespace

Term::Term() = default;

Term Term::truth(bool value) {
  static const Term yes(
      std::make_shared<const TermNode>(TermNode{Kind::truth, Type::truth(), true, digest_of(Kind::truth, 1)}));
  static const Term no(
      std::make_shared<const TermNode>(TermNode{Kind::truth, Type::truth(), false, digest_of(Kind::truth, 0)}));
  return value ? yes : no;
}

Term Term::number(double value) {
  if (!std::isfinite(value)) return Term();
  value += 0.0;
  const auto digest = digest_of(Kind::number, std::bit_cast<std::uint64_t>(value));
  return Term(std::make_shared<const TermNode>(TermNode{Kind::number, Type::number(), value, digest}));
}

Term Term::text(std::string value) {
  const auto size = 1 + value.size() / 16;
  const auto digest = digest_of(Kind::text, value);
  return Term(
      std::make_shared<const TermNode>(TermNode{Kind::text, Type::text_type(), std::move(value), digest, 0, 1, size}));
}

namespace {
// Dividing by the number of steps gives the double nearest to the decimal; + 0.0 turns -0 into 0.
double to_micrometre(double metres) { return std::round(metres * 1e6) / 1e6 + 0.0; }
}  // namespace

Term Term::place(Place value) {
  for (std::size_t i = 0; i < 3; ++i) {
    value.min[i] = to_micrometre(value.min[i]);
    value.max[i] = value.region ? to_micrometre(value.max[i]) : value.min[i];
    if (!std::isfinite(value.min[i]) || !std::isfinite(value.max[i])) return Term();
    if (value.max[i] < value.min[i]) std::swap(value.min[i], value.max[i]);
  }
  return Term(std::make_shared<const TermNode>(TermNode{Kind::place, Type::location(), value, digest_of(value)}));
}

Term Term::point(double x_m, double y_m, double z_m) { return place({{x_m, y_m, z_m}, {x_m, y_m, z_m}, false}); }

Term Term::constant(std::string_view name, Type type) {
  const auto digest = digest_of(Kind::constant, name);
  return Term(std::make_shared<const TermNode>(TermNode{Kind::constant, std::move(type), Name(name), digest}));
}

Term Term::entity(std::string_view name) { return constant(name, Type::entity()); }

Term Term::bound(int index, Type type) {
  require(index >= 0, "a bound variable has an index from 0");
  const auto digest = digest_of(Kind::bound, static_cast<std::uint64_t>(index));
  return Term(std::make_shared<const TermNode>(TermNode{Kind::bound, std::move(type), index, digest, index + 1}));
}

Term Term::lambda(std::string hint, Type variable, Term body) {
  auto type = Type::function(variable, body.type());
  const auto reach = std::max(0, body.reach() - 1);
  const auto depth = body.depth() + 1, size = saturated(body.size() + 1);
  auto digest = digester(Kind::lambda);
  digest.add(body.digest());
  Binder binder{std::move(hint), std::move(variable), std::move(body)};
  return Term(std::make_shared<const TermNode>(
      TermNode{Kind::lambda, std::move(type), std::move(binder), digest.digest(), reach, depth, size}));
}

Term Term::apply(Term function, Term argument) {
  auto type = result_type(function.type(), argument.type());
  if (!type) return Term();
  return applied_of_type(*std::move(type), std::move(function), std::move(argument));
}

Term Term::applied_like(const Term& application, Term function, Term argument) {
  const auto& like = std::get<Pair>(application.node_->held);
  if (!function.type().same_node(like.function.type()) || !argument.type().same_node(like.argument.type()))
    return apply(std::move(function), std::move(argument));
  return applied_of_type(application.type(), std::move(function), std::move(argument));
}

Term Term::applied_of_type(Type type, Term function, Term argument) {
  const auto reach = std::max(function.reach(), argument.reach());
  const auto depth = std::max(function.depth(), argument.depth()) + 1;
  const auto size = saturated(function.size() + argument.size() + 1);
  auto digest = digester(Kind::apply);
  digest.add(function.digest());
  digest.add(argument.digest());
  Pair application{std::move(function), std::move(argument)};
  return Term(std::make_shared<const TermNode>(
      TermNode{Kind::apply, std::move(type), std::move(application), digest.digest(), reach, depth, size}));
}

Term Term::list(std::vector<Term> elements, Type element) {
  int reach = 0;
  std::size_t depth = 0, size = 1;
  auto digest = digester(Kind::list);
  for (const auto& each : elements) {
    digest.add(each.digest());
    reach = std::max(reach, each.reach());
    depth = std::max(depth, each.depth());
    size = saturated(size + each.size());
  }
  digest.add(elements.size(), 0);
  return Term(std::make_shared<const TermNode>(TermNode{Kind::list, Type::list(std::move(element)), std::move(elements),
                                                        digest.digest(), reach, depth + 1, size}));
}

Term::Kind Term::kind() const { return node_ ? node_->kind : Kind::null; }
const Type& Term::type() const { return node_ ? node_->type : Type::term(); }
bool Term::is_true() const { return kind() == Kind::truth && std::get<bool>(node_->held); }
int Term::reach() const { return node_ ? node_->reach : 0; }
std::size_t Term::depth() const { return node_ ? node_->depth : 1; }
std::size_t Term::size() const { return node_ ? node_->size : 1; }

bool Term::truth_value() const {
  require(kind() == Kind::truth, "truth_value() of a term that is no truth value");
  return std::get<bool>(node_->held);
}
double Term::number_value() const {
  require(kind() == Kind::number, "number_value() of a term that is no number");
  return std::get<double>(node_->held);
}
const std::string& Term::text_value() const {
  require(kind() == Kind::text, "text_value() of a term that is no text");
  return std::get<std::string>(node_->held);
}
const Place& Term::place_value() const {
  require(kind() == Kind::place, "place_value() of a term that is no place");
  return std::get<Place>(node_->held);
}
const std::string& Term::name() const {
  if (kind() == Kind::lambda) return std::get<Binder>(node_->held).hint;
  require(kind() == Kind::constant, "name() of a term that is neither constant nor lambda");
  return std::get<Name>(node_->held).text();
}
Name Term::interned_name() const {
  require(kind() == Kind::constant, "interned_name() of a term that is no constant");
  return std::get<Name>(node_->held);
}
int Term::index() const {
  require(kind() == Kind::bound, "index() of a term that is no bound variable");
  return std::get<int>(node_->held);
}
const Term& Term::body() const {
  require(kind() == Kind::lambda, "body() of a term that is no lambda");
  return std::get<Binder>(node_->held).body;
}
const Type& Term::variable_type() const {
  require(kind() == Kind::lambda, "variable_type() of a term that is no lambda");
  return std::get<Binder>(node_->held).variable;
}
const Term& Term::function() const {
  require(kind() == Kind::apply, "function() of a term that is no application");
  return std::get<Pair>(node_->held).function;
}
const Term& Term::argument() const {
  require(kind() == Kind::apply, "argument() of a term that is no application");
  return std::get<Pair>(node_->held).argument;
}
const std::vector<Term>& Term::elements() const {
  require(kind() == Kind::list, "elements() of a term that is no list");
  return std::get<std::vector<Term>>(node_->held);
}

TermSpine Term::spine() const {
  TermSpine spine;
  const Term* head = this;
  for (; head->kind() == Kind::apply; head = &head->function()) spine.arguments.push_back(head->argument());
  std::reverse(spine.arguments.begin(), spine.arguments.end());
  spine.head = *head;
  return spine;
}

const TermDigest& Term::digest() const {
  static const TermDigest null = digester(Kind::null).digest();
  return node_ ? node_->digest : null;
}

const Term* first_place(const Term& term) {
  switch (term.kind()) {
    case Term::Kind::place:
      return &term;
    case Term::Kind::lambda:
      return first_place(term.body());
    case Term::Kind::apply: {
      const Term* found = first_place(term.function());
      return found ? found : first_place(term.argument());
    }
    case Term::Kind::list:
      for (const auto& each : term.elements())
        if (const Term* found = first_place(each)) return found;
      return nullptr;
    default:
      return nullptr;
  }
}

}  // namespace continua
