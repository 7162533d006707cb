// Tables of names with their types, rules and nothing else: how functions are added to the language.
#pragma once

#include <initializer_list>
#include <string>

#include "continua/term/evaluate.h"

namespace continua {

/// One function: its name, its type as text, and its computation.
struct Function {
  const char* name;
  const char* type;
  std::function<Term(std::span<const Term>, Evaluation&)> compute;
  bool takes_null = false;
};

/// Adds the functions to `rules` and their types to `signature`. The arity of a function is the number of arrows of
/// its type. Its `compute` may rely on the kinds of its arguments: where the type says num, text, loc or a list, and
/// the argument is no such literal (a name without a value, or something else by way of `term`), the value is null.
/// A name declared twice is a broken invariant.
void add_functions(std::initializer_list<Function> functions, Rules& rules, Signature& signature);

/// The language's own, each file one table.
void add_operators(Rules& rules, Signature& signature);
void add_list_functions(Rules& rules, Signature& signature);
void add_term_functions(Rules& rules, Signature& signature);
void add_place_functions(Rules& rules, Signature& signature);

}  // namespace continua
