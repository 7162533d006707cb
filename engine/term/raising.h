// Raising: lifts an argument of the wrong type to the wanted type, if a rule allows it (SEMANTICS.md §2): an object to
// the place on, in or at it, a point to a region, an object to the set of its properties, an event to its theme. The
// rules are data (term/raising_file.h).
#pragma once

#include <optional>
#include <string>

#include "continua/term/evaluate.h"

namespace continua {

struct RaisingRule {
  std::string name;
  Type from = Type::term(), to = Type::term();
  std::optional<Term> when;  ///< of type from -> t: true of arguments that may be raised; without it all may
  Term by;                   ///< of type from -> to
};

/// Whether `argument` may stand in a place of type `wanted` without raising. Its type must be consistent with `wanted`;
/// for a region, a literal place must have an extent. Null fits everywhere.
bool fits(const Term& argument, const Type& wanted);

struct Raised {
  Term term;
  std::string rule;
};

/// Raises `argument`, a value, by the first rule that leads from its type to the wanted one, has a true condition and
/// gives a value that fits. The result is a value.
std::optional<Raised> raised(const Term& argument, const Type& wanted, const RaisingRules& rules,
                             Evaluation& evaluation);

}  // namespace continua
