#include "continua/knowledge_files/deictic_program.h"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/term/rules.h"

namespace continua {
namespace {

constexpr std::array<const char*, 3> vector_types = {"agent", "finger", "location"};

const std::string& type_of(const Expression& name, const Voxeme& program) {
  static const std::string none;
  const auto& all = program.arguments;
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name.name; });
  return found == all.end() ? none : found->type;
}

const Expression* assignment_in(const Voxeme& program) {
  for (const auto& step : program.body)
    if (step.event.name == "def" && step.event.arguments.size() == 2 && is_vector(step.event.arguments[0]) &&
        step.event.arguments[1].arguments.size() == 1)
      return &step.event;
  return nullptr;
}

Term applied(Term function, std::initializer_list<Term> arguments) {
  for (const auto& each : arguments) function = Term::apply(std::move(function), each);
  return function;
}

// \x y s z. dot(met(vec(x, y, z), s), z)
Term function_of(const Expression& vector) {
  const Type e = Type::entity(), loc = Type::location(), num = Type::number();
  const Term x = Term::bound(3, e), y = Term::bound(2, e), s = Term::bound(1, num), z = Term::bound(0, loc);
  const Term met = applied(met_name(), {applied(vector_name(), {x, y, z}), s});
  Term function = Term::lambda(vector.arguments[2].name, loc, applied(pointing_constructor(), {met, z}));
  function = Term::lambda("sd", num, std::move(function));
  function = Term::lambda(vector.arguments[1].name, e, std::move(function));
  return Term::lambda(vector.arguments[0].name, e, std::move(function));
}

}  // namespace

Result<std::optional<DeicticProgram>> deictic_program(const Catalogue& catalogue) {
  const Voxeme* program = catalogue.find(Voxeme::Entity::program, pointing_predicate);
  if (!program || program->head.name != "assignment") return std::optional<DeicticProgram>();
  const auto wrong = [&](std::string sentence) { return Error{program->path, std::move(sentence)}; };
  const auto* assigns = assignment_in(*program);
  if (!assigns) return wrong("no step defines what is pointed at, expected def(vec(x -> y × z),as(w))");
  const auto& vector = assigns->arguments[0];
  for (std::size_t i = 0; i < vector_types.size(); ++i)
    if (const auto& type = type_of(vector.arguments[i], *program); type != vector_types[i])
      return wrong(fmt::format("{} in {} has the type {}, expected {}", in_quotes(print(vector.arguments[i])),
                               in_quotes(print(vector)), in_quotes(type), vector_types[i]));
  const auto& named = assigns->arguments[1].arguments[0];
  if (const auto& type = type_of(named, *program); halves_of(type) != std::vector<std::string>{"physobj[]", "location"})
    return wrong(
        fmt::format("{} has the type {}, expected physobj[]•location", in_quotes(named.name), in_quotes(type)));
  DeicticProgram read{program->predicate, function_of(vector)};
  if (program->spread) {
    read.least_sd_m = program->spread->least_m;
    read.sd_per_metre_m = program->spread->per_metre_m;
  }
  if (!(read.least_sd_m > 0)) return wrong("its Spread has a Least of 0 m, expected more");
  return std::optional(std::move(read));
}

}  // namespace continua
