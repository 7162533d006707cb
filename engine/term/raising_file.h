// Reads raising rules from a file such as knowledge/raising.json:
//
//   { "raising": 1,
//     "programs": { "in": "e -> loc" },
//     "rules": [ { "name": "object_to_place_in", "from": "e", "to": "loc",
//                  "when": "\\x. affords(x, 'in')", "by": "in" } ] }
//
// `programs` are names without a rule, with their types. `when` may be missing. The document and each rule may have an
// "about", for people.
#pragma once

#include <string>
#include <string_view>

#include "continua/core/result.h"
#include "continua/term/raising.h"

namespace continua {

/// `names`: the names that terms may use besides the file's programs: the language's and the facts of the world. The
/// error is the first problem of the file: "file:line:column: found …, expected …".
Result<RaisingRules> load_raising(const std::string& path, const Signature& names);

/// Reads rules from text; `name` stands for the file in errors.
Result<RaisingRules> parse_raising(std::string_view text, const std::string& name, const Signature& names);

}  // namespace continua
