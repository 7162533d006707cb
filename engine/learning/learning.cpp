#include "continua/learning/learning.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/term/substitution.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

constexpr const char* thing_names[most_things] = {"x", "y", "z"};
constexpr const char* point_names[most_points] = {"v", "w"};

void add_distinct(std::vector<Term>& terms, const Term& term) {
  if (std::find(terms.begin(), terms.end(), term) == terms.end()) terms.push_back(term);
}

// The theme of an act: its first object argument.
std::optional<Term> theme_of(const Term& act) {
  for (const auto& argument : act.spine().arguments)
    if (argument.kind() == Term::Kind::constant && argument.type() == Type::entity()) return argument;
  return std::nullopt;
}

void collect_points(const Term& term, std::vector<Term>& points) {
  switch (term.kind()) {
    case Term::Kind::place:
      if (!term.place_value().region) add_distinct(points, term);
      return;
    case Term::Kind::lambda:
      return collect_points(term.body(), points);
    case Term::Kind::apply:
      collect_points(term.function(), points);
      return collect_points(term.argument(), points);
    case Term::Kind::list:
      for (const auto& element : term.elements()) collect_points(element, points);
      return;
    default:
      return;
  }
}

const Term& below_lambdas(const Term& term) {
  return term.kind() == Term::Kind::lambda ? below_lambdas(term.body()) : term;
}

// The learned program that an act names, or nullptr.
const Program* program_of(const Term& act, const Learned& learned) {
  const auto head = act.spine().head;
  if (head.kind() != Term::Kind::constant) return nullptr;
  const auto found = learned.programs.find(head.name());
  return found == learned.programs.end() ? nullptr : &found->second;
}

// Whether `program` expands to an act called `name`. Looks at each program once.
bool leads_to(const Program& program, const std::string& name, const Learned& learned, std::set<const Program*>& seen) {
  if (!seen.insert(&program).second) return false;
  for (const auto& act : below_lambdas(program.acts).elements()) {
    const auto head = act.spine().head;
    if (head.kind() == Term::Kind::constant && head.name() == name) return true;
    const auto* other = program_of(act, learned);
    if (other && leads_to(*other, name, learned, seen)) return true;
  }
  return false;
}

Error too_many(const char* what, std::size_t found, std::size_t most) {
  return {"", fmt::format("found {} {}, expected at most {}", found, what, most)};
}

}  // namespace

std::vector<Type> Program::parameters() const {
  std::vector<Type> types;
  for (const Term* at = &acts; at->kind() == Term::Kind::lambda; at = &at->body()) types.push_back(at->variable_type());
  return types;
}

Type Program::type() const {
  auto type = Type::truth();
  const auto types = parameters();
  for (auto each = types.rbegin(); each != types.rend(); ++each) type = Type::function(*each, type);
  return type;
}

Result<Program> composed(const std::vector<Term>& acts) {
  if (acts.empty()) return Error{"", "nothing was done; expected one act or more"};
  if (acts.size() > most_acts) return too_many("acts", acts.size(), most_acts);
  std::vector<Term> things, points;
  for (const auto& act : acts) {
    if (act.is_null() || !act.closed() || !consistent(act.type(), Type::truth()))
      return Error{"", fmt::format("found {}, expected an act that lacks nothing", print(act))};
    if (const auto theme = theme_of(act)) add_distinct(things, *theme);
    collect_points(act, points);
  }
  if (things.size() > most_things) return too_many("things acted on", things.size(), most_things);
  if (points.size() > most_points) return too_many("points", points.size(), most_points);
  // The last parameter is the innermost lambda.
  Term body = Term::list(acts, Type::truth());
  for (std::size_t i = points.size(); i-- > 0;)
    body = Term::lambda(point_names[i], Type::location(), abstracted(body, points[i]));
  for (std::size_t i = things.size(); i-- > 0;)
    body = Term::lambda(thing_names[i], Type::entity(), abstracted(body, things[i]));
  return Program{body};
}

Result<std::vector<Term>> applied(const Program& program, const std::vector<Term>& arguments,
                                  std::vector<Application>& made) {
  const auto types = program.parameters();
  if (arguments.size() != types.size())
    return Error{"", fmt::format("found {} arguments, expected {}", arguments.size(), types.size())};
  Term body = program.acts;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (arguments[i].is_null() || !arguments[i].closed() || !consistent(arguments[i].type(), types[i]))
      return Error{"", fmt::format("found {}, expected an argument of type {}", print(arguments[i]), types[i].text())};
    Term result = instantiate(body.body(), arguments[i]);
    made.push_back({std::move(body), arguments[i], result, ""});
    body = std::move(result);
  }
  return body.elements();
}

const Program* Learned::program_called(std::string_view name) const {
  if (const auto found = programs.find(name); found != programs.end()) return &found->second;
  const auto found =
      std::find_if(programs.begin(), programs.end(), [&](const auto& each) { return each.second.word == name; });
  return found == programs.end() ? nullptr : &found->second;
}

void Learned::learn_shape(const std::string& gesture, const Shape& shape) {
  auto& exemplars = shapes[gesture];
  if (std::find(exemplars.begin(), exemplars.end(), shape) == exemplars.end()) exemplars.push_back(shape);
}

Outcome Learned::learn_program(const std::string& name, Program program) {
  std::set<const Program*> seen;
  if (leads_to(program, name, *this, seen))
    return Error{"", fmt::format("what {} stands for leads back to itself", in_quotes(name))};
  programs.insert_or_assign(name, std::move(program));
  return std::nullopt;
}

Result<std::vector<Term>> Learned::acts_of(const Term& act, std::vector<Application>& made) const {
  std::vector<Term> acts, open = {act};  // `open`: acts still to be expanded, the next one last
  for (std::size_t count = 0; !open.empty(); ++count) {
    if (count > most_acts) return Error{"", fmt::format("{} comes to more than {} acts", print(act), most_acts)};
    const Term next = std::move(open.back());
    open.pop_back();
    const auto* program = program_of(next, *this);
    if (!program) {
      acts.push_back(next);
      continue;
    }
    auto parts = applied(*program, next.spine().arguments, made);
    if (!parts) return Error{"", fmt::format("{} in {}", parts.error().sentence, print(next))};
    open.insert(open.end(), parts->rbegin(), parts->rend());
  }
  return acts;
}

}  // namespace continua
