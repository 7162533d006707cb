#include "machine_file/machine_parameters.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/local_time.h"
#include "machine_file/machine_reader.h"

namespace continua {
namespace {

std::optional<Term> term_of(const Json& value) {
  if (value.is_boolean()) return Term::truth(value.get<bool>());
  if (value.is_number()) return Term::number(value.get<double>());
  if (value.is_string()) return Term::text(value.get<std::string>());
  return std::nullopt;
}

Json json_of(const Term& term) {
  if (term.kind() == Term::Kind::text) return term.text_value();
  if (term.kind() == Term::Kind::number) return term.number_value();
  return term.is_true();
}

const char* kind_of(const Term& term) {
  if (term.kind() == Term::Kind::text) return "a text";
  return term.kind() == Term::Kind::number ? "a number" : "true or false";
}

constexpr const char* value_wanted = "true, false, a number or a text";

}  // namespace

void MachineReader::read_parameters(const Item& parameters) {
  if (!expect_object(parameters, "parameters")) return;
  for (const auto& [name, description] : parameters.json->items()) {
    const auto item = member(parameters, name);
    if (!expect_object(item, "a parameter")) continue;
    const auto value = required(item, "value", value_wanted);
    if (!value.json) continue;
    const auto term = term_of(*value.json);
    if (!term) {
      mismatch(value, value_wanted);
      continue;
    }
    Parameter parameter{name, *term, {}};
    if (const auto until = member(item, "until"); expect_object(until, "values by the times until which they held"))
      for (const auto& [time, earlier] : until.json->items()) {
        const auto then = member(until, time);
        if (!is_local_time(time))
          problem_at_key(then, fmt::format("found {}, expected {}", in_quotes(time), local_time_wanted));
        const auto value_then = term_of(earlier);
        if (value_then && value_then->type() == term->type())
          parameter.until.emplace(time, *value_then);
        else
          mismatch(then, kind_of(*term));
      }
    declare(item, name, term->type());
    machine_.definitions.emplace(name, *term);
    machine_.parameters.push_back(std::move(parameter));
  }
}

Json parameter_values(const Machine& machine) {
  Json values = Json::object();
  for (const auto& parameter : machine.parameters) values[parameter.name] = json_of(parameter.value);
  return values;
}

Json parameter_values_at(const Machine& machine, std::string_view recorded) {
  Json values = Json::object();
  for (const auto& parameter : machine.parameters) {
    const auto then = parameter.until.upper_bound(recorded);
    values[parameter.name] = json_of(then == parameter.until.end() ? parameter.value : then->second);
  }
  return values;
}

Outcome set_parameters(Machine& machine, const Json& values, const std::string& where) {
  for (const auto& [name, value] : values.items()) {
    const auto found = std::find_if(machine.parameters.begin(), machine.parameters.end(),
                                    [&name = name](const Parameter& one) { return one.name == name; });
    if (found == machine.parameters.end()) {
      std::vector<std::string> known;
      for (const auto& one : machine.parameters) known.push_back(one.name);
      return Error{where, fmt::format("the machine {} has no parameter {}{}", machine.name, in_quotes(name),
                                      did_you_mean(name, known))};
    }
    const auto term = term_of(value);
    if (!term || term->type() != found->value.type())
      return Error{where, fmt::format("the parameter {} of the machine {} is {}; expected {}", in_quotes(name),
                                      machine.name, compact(value), kind_of(found->value))};
    found->value = *term;
    machine.definitions.insert_or_assign(name, *term);
  }
  machine.index();
  return std::nullopt;
}

}  // namespace continua
