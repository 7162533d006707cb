// From the syntax of a text to a term: names are found, types inferred.
#pragma once

#include "continua/core/result.h"
#include "continua/term/syntax.h"
#include "continua/term/term_text.h"

namespace continua {

/// `expected` may be null: any type will do. Names of core_signature() are known too, after those of `names`.
Result<Term> elaborate(Syntax syntax, const Signature& names, const Type* expected);

}  // namespace continua
