// Raising: an argument of the wrong type is lifted to the wanted one, where a rule allows it (SEMANTICS.md §2): an
// object to the place on, in or at it, a point to a region, an object to the true statements about its properties, an
// event to its theme. The rules are data (term/raising_file.h).
#pragma once

#include <optional>
#include <string>

#include "continua/term/evaluate.h"

namespace continua {

struct RaisingRule {
  std::string name;
  Type from = Type::term(), to = Type::term();
  std::optional<Term> when;  ///< of type from -> t: true of the arguments that may be raised; without it all may
  Term by;                   ///< of type from -> to
};

/// May `argument` stand where `wanted` is expected, as it is: its type is consistent with it, and a place that is
/// written out has an extent where a region is wanted. Null may stand everywhere.
bool fits(const Term& argument, const Type& wanted);

struct Raised {
  Term term;
  std::string rule;
};

/// Raises the argument by the first rule, in their order, that goes from its type to the wanted one, whose condition is
/// true of it, and whose result fits. The argument and the result are values.
std::optional<Raised> raised(const Term& argument, const Type& wanted, const RaisingRules& rules,
                             Evaluation& evaluation);

}  // namespace continua
