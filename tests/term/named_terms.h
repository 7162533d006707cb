// Terms with named variables, substituted and reduced by the book: the reference for numbered binders and evaluation.
#pragma once

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "read_terms.h"

namespace continua {

struct Named {
  enum class Kind { leaf, variable, lambda, apply, list };
  Kind kind = Kind::leaf;
  Term leaf;         ///< of a list: a list of its type
  std::string name;  ///< of a variable, or of a lambda's
  Type type = Type::term();
  std::vector<Named> parts;

  bool is(const Term& term) const { return kind == Kind::leaf && leaf == term; }
};

inline std::set<std::string> free_names(const Named& term) {
  std::set<std::string> names;
  if (term.kind == Named::Kind::variable) names.insert(term.name);
  for (const auto& part : term.parts) names.merge(free_names(part));
  if (term.kind == Named::Kind::lambda) names.erase(term.name);
  return names;
}

inline std::string fresh_name(const std::set<std::string>& taken) {
  std::string name = "x";
  while (taken.contains(name)) name += '\'';
  return name;
}

/// `variables` are the names and types around the term, the innermost last. Binders take the first name that their
/// body leaves free, so that the same name is bound again and again.
inline Named named(const Term& term, const std::vector<std::string>& variables) {
  switch (term.kind()) {
    case Term::Kind::bound:
      return {Named::Kind::variable, {}, variables[variables.size() - 1 - term.index()], term.type(), {}};
    case Term::Kind::lambda: {
      auto inner = variables;
      inner.emplace_back("(its own)");
      const auto name = fresh_name(free_names(named(term.body(), inner)));
      inner.back() = name;
      return {Named::Kind::lambda, {}, name, term.variable_type(), {named(term.body(), inner)}};
    }
    case Term::Kind::apply:
      return {Named::Kind::apply,
              {},
              "",
              Type::term(),
              {named(term.function(), variables), named(term.argument(), variables)}};
    case Term::Kind::list: {
      Named list{Named::Kind::list, {}, "", term.type().element(), {}};
      for (const auto& each : term.elements()) list.parts.push_back(named(each, variables));
      return list;
    }
    default:
      return {Named::Kind::leaf, term, "", term.type(), {}};
  }
}

inline Term numbered(const Named& term, const std::vector<std::string>& variables) {
  switch (term.kind) {
    case Named::Kind::leaf:
      return term.leaf;
    case Named::Kind::variable: {
      const auto found = std::find(variables.rbegin(), variables.rend(), term.name);
      REQUIRE(found != variables.rend());
      return Term::bound(static_cast<int>(found - variables.rbegin()), term.type);
    }
    case Named::Kind::lambda: {
      auto inner = variables;
      inner.push_back(term.name);
      return Term::lambda(term.name, term.type, numbered(term.parts[0], inner));
    }
    case Named::Kind::apply:
      return Term::apply(numbered(term.parts[0], variables), numbered(term.parts[1], variables));
    case Named::Kind::list: {
      std::vector<Term> elements;
      for (const auto& each : term.parts) elements.push_back(numbered(each, variables));
      return Term::list(std::move(elements), term.type);
    }
  }
  return Term();
}

inline Named substituted(const Named& term, const std::string& name, const Named& by) {
  if (term.kind == Named::Kind::variable && term.name == name) return by;
  if (term.kind == Named::Kind::lambda && term.name == name) return term;
  Named result = term;
  if (term.kind == Named::Kind::lambda && free_names(by).contains(term.name)) {
    auto taken = free_names(by);
    taken.merge(free_names(term.parts[0]));
    taken.insert(name);
    result.name = fresh_name(taken);
    const Named renamed{Named::Kind::variable, {}, result.name, term.type, {}};
    result.parts[0] = substituted(term.parts[0], term.name, renamed);
  }
  for (auto& part : result.parts) part = substituted(part, name, by);
  return result;
}

inline std::optional<Named> reduced_once(const Named& term);

/// The choice of `if`, `and` and `or` where their condition is known; nothing where they wait or are something else.
inline std::optional<Named> chosen(const Named& term) {
  std::vector<Named> arguments;
  Named head = term;
  for (; head.kind == Named::Kind::apply; head = Named(head.parts[0]))
    arguments.insert(arguments.begin(), head.parts[1]);
  if (head.kind != Named::Kind::leaf || head.leaf.kind() != Term::Kind::constant) return std::nullopt;
  const auto name = head.leaf.name();
  if (!(name == "if" && arguments.size() == 3) && !((name == "and" || name == "or") && arguments.size() == 2))
    return std::nullopt;
  const auto known = [](const Named& each) { return free_names(each).empty() && !reduced_once(each); };
  if (!known(arguments[0])) return std::nullopt;
  const bool first = arguments[0].is(Term::truth(true));
  if (name == "if") return arguments[first ? 1 : 2];
  const auto truth = [](bool value) { return Named{Named::Kind::leaf, Term::truth(value), "", Type::truth(), {}}; };
  if (first != (name == "and")) return truth(name == "or");
  if (!known(arguments[1])) return std::nullopt;
  return truth(arguments[1].is(Term::truth(true)));
}

/// One step, the outermost that there is, of those the leftmost.
inline std::optional<Named> reduced_once(const Named& term) {
  if (term.kind == Named::Kind::apply) {
    const auto& function = term.parts[0];
    if (function.kind == Named::Kind::lambda) return substituted(function.parts[0], function.name, term.parts[1]);
    if (function.is(Term::null())) return function;
    if (const auto choice = chosen(term)) return choice;
  }
  for (std::size_t i = 0; i < term.parts.size(); ++i) {
    auto part = reduced_once(term.parts[i]);
    if (!part) continue;
    Named result = term;
    result.parts[i] = std::move(*part);
    return result;
  }
  return std::nullopt;
}

}  // namespace continua
