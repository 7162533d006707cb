#include "continua/term/derivation.h"

#include <algorithm>
#include <unordered_set>

#include "continua/term/evaluate.h"
#include "continua/term/substitution.h"

namespace continua {
namespace {

using Parts = std::unordered_set<Term, TermHash>;

// Adds the term and all its parts. Shared parts are visited once.
void add_parts(const Term& term, Parts& parts) {
  if (!parts.insert(term).second) return;
  switch (term.kind()) {
    case Term::Kind::lambda:
      return add_parts(term.body(), parts);
    case Term::Kind::apply:
      add_parts(term.function(), parts);
      return add_parts(term.argument(), parts);
    case Term::Kind::list:
      for (const auto& each : term.elements()) add_parts(each, parts);
      return;
    default:
      return;
  }
}

Parts parts_of(const Term& term) {
  Parts parts;
  add_parts(term, parts);
  return parts;
}

// The term with constants for the variables of the lambdas around.
Term told(Term term, const std::vector<std::pair<std::string, Type>>& binders) {
  for (auto binder = binders.rbegin(); binder != binders.rend() && !term.closed(); ++binder)
    term = instantiate(term, Term::constant(binder->first, binder->second));
  return term;
}

}  // namespace

void Derivation::enter(const Term& lambda) {
  std::string name = lambda.name();
  while (std::any_of(binders_.begin(), binders_.end(), [&](const auto& outer) { return outer.first == name; }))
    name += '\'';
  binders_.emplace_back(std::move(name), lambda.variable_type());
}

void Derivation::applied(const Term& function, const Term& argument, const Term& result, bool reduced) {
  const bool open = !function.closed() || !argument.closed();
  steps_.push_back({function, argument, result, reduced, open ? binders_ : decltype(binders_){}});
}

std::vector<Application> Derivation::of(const Term& value, std::span<const Application> filled) const {
  if (steps_.empty()) return {};
  const Parts wanted = parts_of(value);
  Parts known;
  for (const auto& each : read_) add_parts(each, known);
  Parts covered;  // by an application of a continuation
  const auto cover = [&](const Term& function, const Term& argument, const Term& result) {
    const Parts given = parts_of(argument), before = parts_of(function);
    for (const auto& each : parts_of(result))
      if (!given.contains(each) && !before.contains(each)) covered.insert(each);
  };
  for (const auto& each : filled) cover(each.function, each.argument, each.result);
  std::vector<const Step*> made;
  const auto counts = [&](const Step& step) { return wanted.contains(step.result) && !known.contains(step.result); };
  Parts functions = known;  // lambdas that were read or made, unlike those of the machine's own definitions
  for (const auto& step : steps_) {
    if (!step.reduced || !counts(step) || !functions.contains(step.function) || covered.contains(step.result)) continue;
    made.push_back(&step);
    functions.insert(step.result);
    cover(step.function, step.argument, step.result);
  }
  for (const auto& step : steps_)
    if (!step.reduced && counts(step) && covered.insert(step.result).second) made.push_back(&step);
  std::sort(made.begin(), made.end());
  std::vector<Application> applications;
  for (const auto* step : made)
    applications.push_back({told(step->function, step->binders), told(step->argument, step->binders),
                            told(step->result, step->binders), ""});
  return applications;
}

}  // namespace continua
