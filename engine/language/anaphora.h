// Pronouns whose antecedent is in the same sentence: "the cup to the right of the knife and behind it".
#pragma once

#include "language/operators.h"
#include "language/reading.h"

namespace continua {

/// The reading with the noun phrase for an "it" (a proform of type e that stands for what is in focus) inside of
/// another noun phrase: the one said last before it there, else before that phrase. An "it" that is itself put
/// somewhere, or somewhere that is behind it, goes by the focus and stays, as do several.
Reading with_antecedent(const Reading& reading, const Operators& operators);

}  // namespace continua
