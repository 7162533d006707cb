// Terms as text, both ways: parse(print(x)) = x.
//
//   \x y. put(x, on(y))        lambda; λ is read too; `\x: e. …` states the variable's type
//   put(block4, on(block1))    application
//   [a, b]  []                 list
//   <0.1, -0.2, 0>             point, metres in W;  box(<..>, <..>) of two literal points is a region literal
//   'text'                     text; \' and \\ inside
//   null true false 12.5 -3
//   (+)  (not)                 an operator as a name
//   `red block`                a name of any characters, never a variable; \` and \\ inside
//   not a   a and b   a or b   = != < <= > >=   + - * /   -x      in the usual order of binding
//
// An operator is sugar for the application of a constant of that name: `a + b` is (+)(a, b), -x is negate(x). A point
// with a coordinate that is not a literal is sugar too: <1, y, 0> is xyz(1, y, 0).
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"
#include "continua/term/term.h"

namespace continua {

/// The types of the names that a term may use. A type with type variables makes its name polymorphic.
using Signature = std::map<std::string, Type, std::less<>>;

/// Names that the notation itself needs: and or not = != < <= > >= + - * / negate if xyz box.
/// Every term may use them, whatever `names` it is read with.
const Signature& core_signature();

/// Reads a term and infers its type (unification; `term` is consistent with every type), which must be consistent
/// with `expected`. Errors name the column (where = "column N"), the text found there and the nearest valid name.
Result<Term> parse_term(std::string_view text, const Signature& names, const Type& expected);
/// Reads a term of any type.
Result<Term> parse_term(std::string_view text, const Signature& names);

/// The names that the text mentions, with those of bound variables; none if the text cannot be read.
std::set<std::string> names_in(std::string_view text);

/// How a lambda prints: as \, or as λ for people. Both can be read.
enum class Lambda { backslash, greek };

/// Prints in the notation above: operators infix, numbers in the shortest form that reads back equal. Bound variables
/// print as their hint, with primes if it would be captured.
std::string print(const Term& term, Lambda lambda = Lambda::backslash);

}  // namespace continua
