#include "continua/machine_file/machine_settings.h"

#include <algorithm>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "continua/machine_file/machine_parameters.h"
#include "continua/machine_file/machine_weights.h"
#include "continua/machine_file/unknown_setting.h"
#include "continua/term/substitution.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

// A number of the machine's rules.
struct Number {
  std::string name;
  double least = 0, most = 1;
  bool more_than_least = false;
  std::function<void(double value, Json& document)> set;

  bool allows(double value) const { return value <= most && (more_than_least ? value > least : value >= least); }
  std::string bounds() const {
    return fmt::format("a number {} {} and up to {}", more_than_least ? "above" : "from", least, most);
  }
};

// The number in a term that has one alone.
std::optional<Term> only_number(const Term& term) {
  std::optional<Term> found;
  int count = 0;
  rewritten(term, [&](const Term& part) -> std::optional<Term> {
    if (part.kind() != Term::Kind::number) return std::nullopt;
    found = part;
    ++count;
    return part;
  });
  return count == 1 ? found : std::nullopt;
}

void add_weights(Machine& machine, std::vector<Number>& all) {
  for (std::size_t i = 0; i < machine.transitions.size(); ++i)
    all.push_back(
        {"weights." + machine.transitions[i].id, 0, heaviest_weight, true, [&machine, i](double value, Json& document) {
           machine.transitions[i].weight = value;
           document["transitions"][i]["weight"] = value;
         }});
}

void add_gates(Machine& machine, std::vector<Number>& all) {
  for (auto& state : machine.states) {
    const auto number = state.gate ? only_number(state.gate->when) : std::nullopt;
    if (!number) continue;
    all.push_back({"gate." + state.name, -1e9, 1e9, false, [&state, number = *number](double value, Json& document) {
                     state.gate->when = replaced(state.gate->when, number, Term::number(value));
                     document["states"][state.name]["gate"]["when"] = print(state.gate->when);
                   }});
  }
}

void add_beliefs(Machine& machine, std::vector<Number>& all) {
  auto& beliefs = machine.beliefs;
  for (std::size_t row = 0; row < beliefs.evidence.size(); ++row) {
    auto& levels = beliefs.evidence[row].levels;
    for (std::size_t level = 0; level < levels.size(); ++level)
      all.push_back({fmt::format("belief.{}.{}", row + 1, level + 1), level == 0 ? 0 : levels[level - 1],
                     level + 1 == levels.size() ? 1 : levels[level + 1], false,
                     [&levels, row, level](double value, Json& document) {
                       levels[level] = value;
                       document["beliefs"]["evidence"][row]["levels"][level] = value;
                     }});
  }
  if (beliefs.concepts.empty()) return;
  all.push_back({"belief.overheard", 0, 1, false, [&beliefs](double value, Json& document) {
                   beliefs.overheard = value;
                   document["beliefs"]["overheard"] = value;
                 }});
}

std::vector<Number> numbers_of(Machine& machine) {
  std::vector<Number> all;
  add_weights(machine, all);
  add_gates(machine, all);
  add_beliefs(machine, all);
  return all;
}

// Machines of other formats have no place for these numbers in their documents.
bool has_own_document(const Machine& machine, const Json& document) {
  const auto transitions = document.is_object() ? document.find("transitions") : document.end();
  return transitions != document.end() && transitions->is_array() && transitions->size() == machine.transitions.size();
}

Outcome set_number(Machine& machine, const std::string& name, const Json& value, Json& document,
                   const std::string& where) {
  const auto numbers = numbers_of(machine);
  const auto found =
      std::find_if(numbers.begin(), numbers.end(), [&](const Number& number) { return number.name == name; });
  if (found == numbers.end()) return Error{where, unknown_setting(machine, name, names_of_settings(machine))};
  if (!value.is_number() || !found->allows(value.get<double>()))
    return Error{where, fmt::format("the value {} of the machine {} is {}; expected {}", in_quotes(name), machine.name,
                                    compact(value), found->bounds())};
  if (!has_own_document(machine, document))
    return Error{where, fmt::format("the machine {} has parameters alone; expected a machine file of the project's own "
                                    "format for {}",
                                    machine.name, in_quotes(name))};
  found->set(value.get<double>(), document);
  return std::nullopt;
}

}  // namespace

std::vector<std::string> names_of_settings(const Machine& machine) {
  std::vector<std::string> names;
  for (const auto& parameter : machine.parameters) names.push_back(parameter.name);
  auto copy = machine;
  for (const auto& number : numbers_of(copy)) names.push_back(number.name);
  return names;
}

Outcome apply_settings(Machine& machine, const Json& values, const std::string& where) {
  Json parameters = Json::object(), document;
  for (const auto& [name, value] : values.items()) {
    if (name.find('.') == std::string::npos) {
      parameters[name] = value;
      continue;
    }
    if (document.is_null()) document = Json::parse(machine.document, nullptr, false);
    if (auto problem = set_number(machine, name, value, document, where)) return problem;
  }
  if (!document.is_null()) machine.document = compact(document);
  return set_parameters(machine, parameters, where);
}

Result<std::pair<std::string, Json>> read_setting(const std::string& text, const std::string& where) {
  const auto equals = text.find('=');
  if (equals == 0 || equals == std::string::npos)
    return Error{where, fmt::format("found {}, expected NAME=VALUE", in_quotes(text))};
  const auto told = text.substr(equals + 1);
  auto value = Json::parse(told, nullptr, false);
  if (value.is_discarded()) value = told;
  return std::pair(text.substr(0, equals), std::move(value));
}

}  // namespace continua
