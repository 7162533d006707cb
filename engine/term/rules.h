// Adds functions to the language: tables of names with their types and rules.
#pragma once

#include <initializer_list>
#include <string>

#include "continua/term/evaluate.h"

namespace continua {

/// A function of the language.
struct Function {
  const char* name;
  const char* type;
  std::function<Term(std::span<const Term>, Evaluation&)> compute;
  bool takes_null = false;
};

/// Adds the functions to `rules` and their types to `signature`. The arity of a function is the number of arrows of
/// its type. Its `compute` may rely on the kinds of its arguments: if a parameter is num, text, loc or a list and the
/// argument is not such a literal (a name without a value, or any value of type `term`), the result is null without a
/// call. A name declared twice is a broken invariant.
void add_functions(std::initializer_list<Function> functions, Rules& rules, Signature& signature);

/// dot : e* -> loc -> e* • loc, the name that makes a pointing of the things there and the place. It computes nothing.
const Term& pointing_constructor();

/// The functions of the language, each file one table.
void add_operators(Rules& rules, Signature& signature);
void add_list_functions(Rules& rules, Signature& signature);
void add_term_functions(Rules& rules, Signature& signature);
void add_place_functions(Rules& rules, Signature& signature);

}  // namespace continua
