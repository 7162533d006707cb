#include "continua/automaton/wording.h"

namespace continua {
namespace {

// One-way matching: a variable of the pattern takes the part of the term that stands in its place.
bool match(const Term& pattern, const Term& term, std::vector<std::optional<Term>>& variables) {
  if (pattern.kind() == Term::Kind::bound && pattern.index() < static_cast<int>(variables.size())) {
    // Index 0 is the innermost lambda, which binds the last variable.
    auto& variable = variables[variables.size() - 1 - static_cast<std::size_t>(pattern.index())];
    if (variable) return *variable == term;
    variable = term;
    return true;
  }
  if (pattern.kind() == Term::Kind::apply)
    return term.kind() == Term::Kind::apply && match(pattern.function(), term.function(), variables) &&
           match(pattern.argument(), term.argument(), variables);
  return pattern == term;
}

Term applied(Term function, const std::vector<Term>& arguments, Evaluation& evaluation) {
  for (const auto& argument : arguments) function = evaluation.apply(function, argument);
  return evaluation.value(function);
}

}  // namespace

std::optional<std::string> fill_template(const Template& text, const std::vector<Term>& arguments,
                                         Evaluation& evaluation) {
  std::string filled = text.literals.front();
  for (std::size_t i = 0; i < text.holes.size(); ++i) {
    const auto value =
        arguments.empty() ? evaluation.value(text.holes[i]) : applied(text.holes[i], arguments, evaluation);
    if (value.is_null()) return std::nullopt;
    filled += (value.kind() == Term::Kind::text ? value.text_value() : print(value)) + text.literals[i + 1];
  }
  return filled;
}

std::optional<std::string> wording_of(const Term& term, const std::vector<Wording>& wordings, Evaluation& evaluation) {
  for (const auto& wording : wordings) {
    std::vector<std::optional<Term>> variables(wording.variables.size());
    if (!match(wording.pattern, term, variables)) continue;
    std::vector<Term> arguments;
    for (const auto& variable : variables) arguments.push_back(variable.value_or(Term::null()));
    if (wording.when && !applied(*wording.when, arguments, evaluation).is_true()) continue;
    if (auto words = fill_template(wording.say, arguments, evaluation)) return words;
  }
  return std::nullopt;
}

}  // namespace continua
