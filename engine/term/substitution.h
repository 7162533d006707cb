// Replaces and abstracts parts of terms, without capture. Parts are found by equality, which ignores types: a part
// should have the same type wherever it occurs. Names of objects do, [] does not.
#pragma once

#include <functional>
#include <optional>

#include "continua/term/term.h"

namespace continua {

/// `body` with `argument` in place of its variable 0, and the other variables lowered by one. No variable is captured.
Term instantiate(const Term& body, const Term& argument);

/// The inverse: the body of a lambda that gives `term` for `part`, a closed term. Each occurrence of `part` becomes
/// variable 0, and the free variables of `term` are raised by one: instantiate(abstracted(term, part), part) = term.
Term abstracted(const Term& term, const Term& part);

/// `term` with the closed term `by` in place of each occurrence of the closed term `part`. If `part` is applied and
/// `by` is a lambda, it takes the argument at once: with \x. cup(x) for `one`, \y. one(y) becomes \y. cup(y).
Term replaced(const Term& term, const Term& part, const Term& by);

/// The term with `by` in place of the first `part`, outer parts first.
Term first_replaced(const Term& term, const Term& part, const Term& by);

/// Whether `term` is the closed term `part` or contains it.
bool contains(const Term& term, const Term& part);

/// Whether the term contains the variable with the index `variable`, counted outside the term's own lambdas.
bool mentions(const Term& term, int variable);

/// f for \x. f(x), for \x y. f(x, y), and so on, if f does not contain the variables. Only the lambdas at the beginning
/// of the term are contracted.
Term eta_contracted(const Term& term);

/// `term` with its parts replaced by the results of `change`, outer parts first; results are not visited again. Bound
/// variables are parts too.
Term rewritten(const Term& term, const std::function<std::optional<Term>(const Term&)>& change);

}  // namespace continua
