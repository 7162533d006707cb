// Lessons as a file, with which the next run can begin:
//
//   { "learned": 1,
//     "gestures": { "claw": { "means": "grasp(cup)", "shapes": [[0.2, 0.9, 0.1]] } },
//     "programs": { "hoist": { "acts": "\\x: e. [grasp(x), lift(x)]" },
//                   "put_taught": { "word": "put", "acts": "[lift(cup)]" } },
//     "nouns": { "bob": { "means": "\\x. x = block1" } } }
#pragma once

#include <string>
#include <string_view>

#include "continua/learning/learning.h"
#include "continua/term/term_text.h"

namespace continua {

/// `names`: the names that terms may use besides the taught ones. Any other name is an object, perhaps of another
/// scene. The error is the first problem of the file: "file:line:column: found …, expected …".
Result<Learned> parse_learned(std::string_view text, const std::string& name, const Signature& names);

/// Prints lines in a fixed order. parse_learned() reads the same lessons back.
std::string print_learned(const Learned& learned);

/// Prints the program with the types of its parameters, which print() of a term leaves out.
std::string print(const Program& program);

}  // namespace continua
