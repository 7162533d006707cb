// Terms put into terms and taken out of them, without capture. Terms are found by equality, which ignores types: a term
// to be found should have the same type wherever it occurs. Names of objects do; [] does not.
#pragma once

#include <functional>
#include <optional>

#include "continua/term/term.h"

namespace continua {

/// `body` with its variable 0 replaced by `argument`, the others lowered by one; no variable is captured.
Term instantiate(const Term& body, const Term& argument);

/// The inverse: the body of a lambda that gives `term` for `part`, a closed term. Each occurrence of `part` becomes
/// variable 0, the variables that reach out of `term` are raised by one. Where `term` has no other variable 0,
/// instantiate(abstracted(term, part), part) = term.
Term abstracted(const Term& term, const Term& part);

/// `by`, a closed term, in place of each occurrence of the closed term `part`. Where that is applied, a lambda takes
/// its argument at once: with \x. cup(x) for `one`, \y. one(y) becomes \y. cup(y).
Term replaced(const Term& term, const Term& part, const Term& by);

/// Is the closed term `part` a part of `term`, or `term` itself?
bool contains(const Term& term, const Term& part);

/// Does the variable occur that is called `variable` outside of the term's own lambdas?
bool mentions(const Term& term, int variable);

/// f for \x. f(x), and for \x y. f(x, y), and so on, where f does not contain the variable. Only the lambdas that a
/// term begins with are looked at.
Term eta_contracted(const Term& term);

/// `term` with the results of `change` in place of its parts, outer parts first; parts of a result are not visited.
/// Bound variables are parts too.
Term rewritten(const Term& term, const std::function<std::optional<Term>(const Term&)>& change);

}  // namespace continua
