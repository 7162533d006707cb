// Builds the term of a phrase from the terms of its words. Functions are applied at once, so that every term of the
// chart is in normal form and equal meanings are equal terms.
#pragma once

#include "continua/term/term.h"

namespace continua {

/// function(argument) in normal form: no lambda is applied to anything, `a and (b and c)` is `a and b and c`,
/// `a and true` is a, a list in a list gives its elements to it. A function of one object takes several as
/// each(several). Null if the reduction takes too many steps or the term grows too large. Both arguments must be closed
/// and in normal form.
Term applied(const Term& function, const Term& argument);

/// \x. first(second(x)) in normal form; `argument` is the type of x.
Term composed(const Term& first, const Term& second, const Type& argument);

/// The normal form of any closed term.
Term normal(const Term& term);

/// `term` with variables named by type and depth: x, y, z, … for objects, v, w, … for places.
Term with_nice_variables(const Term& term);

/// Whether `whole` contains `part`, a closed term.
bool occurs(const Term& part, const Term& whole);

}  // namespace continua
