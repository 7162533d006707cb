// Words whose antecedent is in the same sentence: "the cup to the right of the knife and behind it".
#pragma once

#include "continua/language/operators.h"
#include "continua/language/reading.h"

namespace continua {

/// Replaces the pro-forms that the reading itself gives an antecedent:
/// - A single "it" (a pro-form of type e for the thing in focus) inside a noun phrase becomes the last noun phrase that
///   ends before it, else the last one that ends before its phrase. An "it" that is itself an argument of the command,
///   a goal that depends on such an "it", and several "it" are left to the focus.
/// - An "other" (a pro-form of source `other`) in a noun phrase becomes "not the last noun phrase before it of the same
///   kind of thing": "put the white cup next to the other cup". Without such a phrase the "other" is left to the focus.
Reading with_antecedents(const Reading& reading, const Operators& operators);

}  // namespace continua
