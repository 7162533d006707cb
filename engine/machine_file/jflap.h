// JFLAP files (.jff) of finite and pushdown automata, as machines of ours (FORMAT.md).
//
//   fa    a transition reads its label: plain characters, or [x-y], which reads one character from x to y, as JFLAP 7
//         does
//   pda   Z is on the stack at first, above the bottom symbol of our machines. The leftmost character of `pop` is the
//         topmost symbol, the leftmost of `push` ends on top. Z may be popped and the stack be empty; a transition that
//         pops nothing works then too
//
// A symbol is a character. λ is a missing or empty element; line breaks and the space around them do not count. A word
// is accepted in a final state. A transition that reads or pops several symbols becomes a chain of passing states;
// chains share their beginnings, so at most one transition applies wherever that was so in the file.
#pragma once

#include <string>
#include <string_view>

#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

/// Whether the file called `name` is JFLAP's: by its name's ending or its root element.
bool is_jflap(std::string_view text, std::string_view name);

/// The machine file with the same meaning, for parse_machine. `name` stands for the file in errors ("file:line: found;
/// expected") and names the machine.
Result<Json> machine_of_jflap(std::string_view text, const std::string& name);

}  // namespace continua
