#include "continua/machine_file/machine_parameters.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/core/local_time.h"
#include "continua/machine_file/machine_keys.h"
#include "continua/machine_file/machine_terms.h"

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

// The earlier values of a parameter, by the times until which they held; each has the type of `value`.
std::map<std::string, Term, std::less<>> earlier_values(const Item& until, const Term& value) {
  std::map<std::string, Term, std::less<>> values;
  for (const auto& [time, then] : until.members("values by the times until which they held")) {
    if (!is_local_time(time))
      then.problem_at_key(fmt::format("found {}, expected {}", in_quotes(time), local_time_wanted));
    const auto earlier = term_of(then.json());
    if (earlier && earlier->type() == value.type())
      values.emplace(time, *earlier);
    else
      then.mismatch(kind_of(value));
  }
  return values;
}

}  // namespace

std::vector<Parameter> read_parameters(const Item& item, TermReader& terms) {
  std::vector<Parameter> parameters;
  for (const auto& [name, entry] : item.members("parameters")) {
    if (!expect_kind(entry, "a parameter")) continue;
    const auto value = entry.required("value", value_wanted);
    if (!value.exists()) continue;
    const auto term = term_of(value.json());
    if (!term) {
      value.mismatch(value_wanted);
      continue;
    }
    terms.declare(entry, name, term->type());
    parameters.push_back({name, *term, earlier_values(entry.member("until"), *term)});
  }
  return parameters;
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
                                    [&name = name](const Parameter& parameter) { return parameter.name == name; });
    if (found == machine.parameters.end()) {
      std::vector<std::string> known;
      for (const auto& parameter : machine.parameters) known.push_back(parameter.name);
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
