// Terms as text, both ways: parse(print(x)) = x.
//
//   \x y. put(x, on(y))        lambda; λ is read too; `\x: e. …` states the variable's type
//   put(block4, on(block1))    application
//   [a, b]  []                 list
//   <0.1, -0.2, 0>             point, metres in W;  box(<..>, <..>) of two literal points is a region literal
//   'text'                     text; \' and \\ inside
//   null true false 12.5 -3
//   (+)  (not)                 an operator as a name
//   `red block`                a name of any characters; \` and \\ inside. No variable is meant by it
//   not a   a and b   a or b   = != < <= > >=   + - * /   -x      in the usual order of binding
//
// An operator is sugar for a constant of that name applied: `a + b` is (+)(a, b), -x is negate(x). A point whose
// coordinates are not all written out is sugar too: <1, y, 0> is xyz(1, y, 0).
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"
#include "continua/term/term.h"

namespace continua {

/// The types of the names a term may use; type variables in them make the name polymorphic.
using Signature = std::map<std::string, Type, std::less<>>;

/// Names that the notation itself needs: and or not = != < <= > >= + - * / negate if xyz box. They are known to every
/// term, whatever the `names`.
const Signature& core_signature();

/// Reads a term and infers its type (unification; `term` is consistent with every type), which must be consistent with
/// `expected`. Errors name the column (where = "column N"), the text found there and the nearest valid name.
Result<Term> parse_term(std::string_view text, const Signature& names, const Type& expected);
/// The same for a term of any type.
Result<Term> parse_term(std::string_view text, const Signature& names);

/// The names that the text mentions, those of bound variables included; none where it cannot be read.
std::set<std::string> names_in(std::string_view text);

/// How a lambda prints: as \, or as λ for people. Both are read.
enum class Lambda { backslash, greek };

/// In the notation above, operators infix, numbers in their shortest form that reads back equal.
/// Bound variables print their hint, primed where it would be captured.
std::string print(const Term& term, Lambda lambda = Lambda::backslash);

}  // namespace continua
