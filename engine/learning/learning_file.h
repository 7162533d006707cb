// Lessons as a file with which the next run begins:
//
//   { "learned": 1,
//     "gestures": { "claw": { "means": "grasp(cup)" } },
//     "programs": { "hoist": { "acts": "\\x: e. [grasp(x), lift(x)]" } } }
#pragma once

#include <string>
#include <string_view>

#include "continua/learning/learning.h"
#include "continua/term/term_text.h"

namespace continua {

/// `names` are the names that terms may use besides learned ones; any other is an object, which may be of another
/// scene. The error is the first problem of the file: "file:line:column: found, expected".
Result<Learned> parse_learned(std::string_view text, const std::string& name, const Signature& names);

/// Lines in a fixed order; parse_learned gives the same again.
std::string print_learned(const Learned& learned);

/// With the types of its parameters, which print() of a term leaves out.
std::string print(const Program& program);

}  // namespace continua
