// The parts of an utterance that pointing can give content to (SEMANTICS.md §3, Ensembles).
#pragma once

#include <vector>

#include "continua/language/operators.h"
#include "continua/language/reading.h"

namespace continua {

struct Demonstrative {
  WordSpan words;
  bool needs = false;  ///< it asks for pointing: there, that cup. Else pointing can tell which is meant: the cup, cup
};

/// Those of a reading, in the order of their words, none inside another: definite noun phrases, nouns alone, and
/// pro-forms that are shown.
std::vector<Demonstrative> demonstratives(const Reading& reading, const Operators& operators);

}  // namespace continua
