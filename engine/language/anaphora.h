// Words whose antecedent is in the same sentence: "the cup to the right of the knife and behind it".
#pragma once

#include "continua/language/operators.h"
#include "continua/language/reading.h"

namespace continua {

/// The reading with what it says of itself put in:
/// - for an "it" (a proform of type e that stands for what is in focus) inside of a noun phrase the noun phrase said
/// last
///   before it there, else before that phrase. An "it" that is itself put somewhere, or somewhere that is behind it,
///   goes by the focus and stays, as do several;
/// - for an "other" (a proform of source `other`) in a noun phrase "not that" of the last noun phrase before it that
///   speaks of the same kind of thing: "put the white cup next to the other cup". Where there is none it goes by the
///   focus and stays.
Reading with_antecedents(const Reading& reading, const Operators& operators);

}  // namespace continua
