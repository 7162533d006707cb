// From the syntax of a text to a term: resolves names, infers types.
#pragma once

#include "continua/core/result.h"
#include "continua/term/syntax.h"
#include "continua/term/term_text.h"

namespace continua {

/// `expected`: nullptr for any type. Names are looked up in `names`, then in core_signature().
Result<Term> elaborate(Syntax syntax, const Signature& names, const Type* expected);

}  // namespace continua
