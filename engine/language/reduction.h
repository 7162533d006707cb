// How the terms of words become the term of a phrase: functions are applied at once, so that every term of the chart is
// in normal form and equal meanings are equal terms.
#pragma once

#include "continua/term/term.h"

namespace continua {

/// function(argument) in normal form: no lambda is applied to anything, `a and (b and c)` is `a and b and c`,
/// `a and true` is a, a list in a list gives its elements to it. Where one object is taken, several are each(several).
/// Null where that takes too many steps or grows too large. Both must be closed and in normal form.
Term applied(const Term& function, const Term& argument);

/// \x. first(second(x)) in normal form; `argument` is the type of x.
Term composed(const Term& first, const Term& second, const Type& argument);

/// The normal form of any closed term.
Term normal(const Term& term);

/// Equal to `term`, with variables named by their types and depth: x, y, z, … for objects, v, w, … for places.
Term with_nice_variables(const Term& term);

/// Whether `part`, a closed term, occurs in `whole`.
bool occurs(const Term& part, const Term& whole);

}  // namespace continua
