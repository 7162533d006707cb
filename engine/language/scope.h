// Names that mean something else within others: under a prohibition an indefinite is universal.
#pragma once

#include "continua/language/reading.h"
#include "continua/language/vocabulary.h"

namespace continua {

/// The reading in which each name that the lexicon's `scope` lists for a name around it has the meaning that is given
/// there: with `each(all(n))` for `a(n)` within `forbid`, "never lift a block" forbids to lift each block. Conditions
/// inside noun phrases stay: "never lift a block on a plate" is about the blocks that are on any plate.
Reading in_scope(const Reading& reading, const Vocabulary& vocabulary);

/// The name under which the vocabulary defines the meaning of `inner` within `outer`.
std::string scoped_name(std::string_view outer, std::string_view inner);

}  // namespace continua
