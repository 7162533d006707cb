// Words whose antecedent is in the same sentence: "the cup to the right of the knife and behind it".
#pragma once

#include "continua/language/operators.h"
#include "continua/language/reading.h"

namespace continua {

/// The reading with antecedents in place of three kinds of pro-form:
/// - A single "it" (type e, source `focus`) inside a noun phrase is replaced by the last noun phrase that ends before
///   it. In a reading of two clauses each "it" is replaced by the subject of the other clause, its first noun phrase,
///   preferably a definite one: "if the red block is on the plate, lift it, otherwise push it". Any other "it" that is
///   an argument of the command, and several inside noun phrases, are left to the focus.
///   A clause also depends on a thing: "without moving the red block, put the cup on it".
/// - "Them" (type e*) in the second of two clauses becomes the list of the things that the first names, if there are
///   several: "if the cup is left of the knife, swap them".
/// - Each "other" (source `other`) in a noun phrase becomes "is not that", with the last noun phrase before it of which
///   all is said that is said here ("a red block … the other red block"), else of which a part is: "put the white cup
///   next to the other cup". "The other one", whose kind is not said, is none of the things named before it. Without
///   such a phrase it is left to the focus.
Reading with_antecedents(const Reading& reading, const Operators& operators);

}  // namespace continua
