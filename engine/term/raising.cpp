#include "continua/term/raising.h"

#include <utility>

namespace continua {
namespace {

bool has_extent(const Place& place) { return place.min != place.max; }

}  // namespace

bool fits(const Term& argument, const Type& wanted) {
  if (argument.is_null()) return true;
  if (!consistent(argument.type(), wanted)) return false;
  return wanted != Type::region() || argument.kind() != Term::Kind::place || has_extent(argument.place_value());
}

std::optional<Raised> raised(const Term& argument, const Type& wanted, const RaisingRules& rules,
                             Evaluation& evaluation) {
  for (const auto& rule : rules) {
    if (!fits(argument, rule.from) || !consistent(rule.to, wanted)) continue;
    if (rule.when && !evaluation.value(Term::apply(*rule.when, argument)).is_true()) continue;
    Term term = evaluation.value(Term::apply(rule.by, argument));
    if (!term.is_null() && fits(term, wanted)) return Raised{std::move(term), rule.name};
  }
  return std::nullopt;
}

}  // namespace continua
