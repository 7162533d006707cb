// The parts of an utterance that pointing can give content to (SEMANTICS.md §3, Ensembles).
#pragma once

#include <vector>

#include "continua/language/operators.h"
#include "continua/language/reading.h"

namespace continua {

struct Demonstrative {
  WordSpan words;
  bool needs = false;  ///< asks for pointing: there, that cup; if false, pointing can tell which is meant: the cup, cup
  bool place = false;  ///< asks for a place: there, the block there; if false, for a thing
  bool more = false;   ///< may be shown besides the thing after it: of "these", how many is not said
};

/// The demonstratives of a reading, in the order of their words: definite noun phrases, other noun phrases that ask
/// for pointing, a noun alone, and pro-forms of source `pointed` or `focus`. A thing inside another that is pointed at
/// by itself cuts the outer one short: "the block between", "this", "this". "these two" are two, each of which is
/// pointed at; "these" are one, and before it as many more as one may point at. A thing that is pointed at by itself
/// and taken back is one, too: of "this, no, that" both.
std::vector<Demonstrative> demonstratives(const Reading& reading, const Operators& operators);

/// Whether the phrase is a thing that is pointed at by itself: this, that cup.
bool is_shown_thing(const Term& phrase, const Operators& operators);

}  // namespace continua
