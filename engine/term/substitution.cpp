#include "continua/term/substitution.h"

#include <algorithm>
#include <utility>

namespace continua {
namespace {

// `term`, below `depth` binders, with the result of `part` in place of each part; `part` gets the part and its depth.
template <class Part>
Term with_parts(const Term& term, int depth, const Part& part) {
  switch (term.kind()) {
    case Term::Kind::lambda:
      return Term::lambda(term.name(), term.variable_type(), part(term.body(), depth + 1));
    case Term::Kind::apply: {
      Term function = part(term.function(), depth);
      return Term::applied_like(term, std::move(function), part(term.argument(), depth));
    }
    case Term::Kind::list: {
      std::vector<Term> elements;
      elements.reserve(term.elements().size());
      for (const auto& each : term.elements()) elements.push_back(part(each, depth));
      return Term::list(std::move(elements), term.type().element());
    }
    default:
      return term;
  }
}

// `term` with `leaf(variable, depth)` in place of each variable bound outside the term where the walk began. Parts
// without such a variable are shared, not rebuilt.
template <class Leaf>
Term with_variables(const Term& term, int depth, const Leaf& leaf) {
  if (term.reach() <= depth) return term;
  if (term.kind() == Term::Kind::bound) return leaf(term, depth);
  return with_parts(term, depth, [&](const Term& part, int below) { return with_variables(part, below, leaf); });
}

Term raised(const Term& term, int by) {
  if (by == 0) return term;
  return with_variables(
      term, 0, [by](const Term& variable, int) { return Term::bound(variable.index() + by, variable.type()); });
}

Term without(const Term& term, const Term& part, int depth) {
  if (term == part) return Term::bound(depth, part.type());
  if (term.kind() == Term::Kind::bound && term.index() >= depth) return Term::bound(term.index() + 1, term.type());
  if (term.reach() <= depth && !contains(term, part)) return term;
  return with_parts(term, depth, [&](const Term& each, int below) { return without(each, part, below); });
}

}  // namespace

Term instantiate(const Term& body, const Term& argument) {
  return with_variables(body, 0, [&](const Term& variable, int depth) {
    if (variable.index() == depth) return raised(argument, depth);
    return Term::bound(variable.index() - 1, variable.type());
  });
}

Term abstracted(const Term& term, const Term& part) {
  require(part.closed(), "what is taken out of a term is closed");
  return without(term, part, 0);
}

Term replaced(const Term& term, const Term& part, const Term& by) {
  require(part.closed() && by.closed(), "what is replaced, and by what, is closed");
  if (term == part) return by;
  if (!contains(term, part)) return term;
  if (term.kind() == Term::Kind::apply && term.function() == part && by.kind() == Term::Kind::lambda)
    return instantiate(by.body(), replaced(term.argument(), part, by));
  return with_parts(term, 0, [&](const Term& each, int) { return replaced(each, part, by); });
}

Term first_replaced(const Term& term, const Term& part, const Term& by) {
  bool done = false;
  return rewritten(term, [&](const Term& each) -> std::optional<Term> {
    if (done || !(each == part)) return std::nullopt;
    done = true;
    return by;
  });
}

bool contains(const Term& term, const Term& part) {
  if (term == part) return true;
  if (term.size() <= part.size()) return false;
  switch (term.kind()) {
    case Term::Kind::lambda:
      return contains(term.body(), part);
    case Term::Kind::apply:
      return contains(term.function(), part) || contains(term.argument(), part);
    case Term::Kind::list:
      return std::any_of(term.elements().begin(), term.elements().end(),
                         [&](const Term& each) { return contains(each, part); });
    default:
      return false;
  }
}

bool mentions(const Term& term, int variable) {
  if (term.reach() <= variable) return false;
  switch (term.kind()) {
    case Term::Kind::bound:
      return term.index() == variable;
    case Term::Kind::lambda:
      return mentions(term.body(), variable + 1);
    case Term::Kind::apply:
      return mentions(term.function(), variable) || mentions(term.argument(), variable);
    case Term::Kind::list:
      return std::any_of(term.elements().begin(), term.elements().end(),
                         [&](const Term& each) { return mentions(each, variable); });
    default:
      return false;
  }
}

Term eta_contracted(const Term& term) {
  if (term.kind() != Term::Kind::lambda) return term;
  const Term body = eta_contracted(term.body());
  const bool applied = body.kind() == Term::Kind::apply && body.argument().kind() == Term::Kind::bound &&
                       body.argument().index() == 0 && !body.function().is_null() && !mentions(body.function(), 0);
  if (applied) return instantiate(body.function(), Term::null());
  return body.same_node(term.body()) ? term : Term::lambda(term.name(), term.variable_type(), body);
}

Term rewritten(const Term& term, const std::function<std::optional<Term>(const Term&)>& change) {
  if (auto changed = change(term)) return *std::move(changed);
  switch (term.kind()) {
    case Term::Kind::lambda: {
      Term body = rewritten(term.body(), change);
      return body.same_node(term.body()) ? term : Term::lambda(term.name(), term.variable_type(), std::move(body));
    }
    case Term::Kind::apply: {
      Term function = rewritten(term.function(), change), argument = rewritten(term.argument(), change);
      if (function.same_node(term.function()) && argument.same_node(term.argument())) return term;
      return Term::apply(std::move(function), std::move(argument));
    }
    case Term::Kind::list: {
      std::vector<Term> elements;
      for (const auto& each : term.elements()) elements.push_back(rewritten(each, change));
      return Term::list(std::move(elements), term.type().element());
    }
    default:
      return term;
  }
}

}  // namespace continua
