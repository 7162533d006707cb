#include "continua/language/operators.h"

#include <algorithm>

#include "continua/term/substitution.h"

namespace continua {

const Determiner* determiner_of(const Term& term, const Operators& operators) {
  if (term.kind() != Term::Kind::apply || term.function().kind() != Term::Kind::constant) return nullptr;
  const auto found = operators.determiners.find(term.function().name());
  return found == operators.determiners.end() ? nullptr : &found->second;
}

const Proform* proform_of(const Term& term, const Operators& operators) {
  if (term.kind() != Term::Kind::constant) return nullptr;
  const auto found = operators.proforms.find(term.name());
  return found == operators.proforms.end() ? nullptr : &found->second;
}

bool says(const Term& term, Proform::Source source, const Operators& operators) {
  return std::any_of(operators.proforms.begin(), operators.proforms.end(), [&](const auto& entry) {
    return entry.second.source == source && contains(term, Term::constant(entry.first, property()));
  });
}

}  // namespace continua
