// The structure of a written term as JSON, for readers that do not know the notation: the page.
#pragma once

#include <string_view>

#include "continua/core/located_json.h"

namespace continua {

/// The term as one of
///   {"kind": "literal", "text"}                        a number, a quoted text, null, true, false
///   {"kind": "name", "name", "quoted"}                 a variable, a constant or an operator; quoted: in backquotes
///   {"kind": "lambda", "name", "type", "body"}         of one variable; type: text or null
///   {"kind": "apply", "head", "args"}                  head(a, b); an operator between operands is the head
///   {"kind": "list", "parts"}, {"kind": "point", "parts"}
/// A text that cannot be read (parse_term() tells why) is a literal.
Json term_structure(std::string_view text);

}  // namespace continua
