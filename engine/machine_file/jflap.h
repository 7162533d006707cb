// Translates JFLAP files (.jff) of finite and pushdown automata into machines (FORMAT.md).
//
//   fa    a transition reads its label as plain characters, except [x-y], which reads one character from x to y, as in
//         JFLAP 7
//   pda   Z is on the stack at the start, above the machine's bottom symbol. The leftmost character of `pop` is the
//         topmost symbol, the leftmost of `push` ends on top. Z may be popped; transitions that pop nothing still apply
//
// A symbol is a character. λ is a missing or empty element; line breaks and the blanks around them do not count. A word
// is accepted in a final state. A transition that reads or pops several symbols becomes a chain of passing states.
// Chains share their beginnings: where at most one transition applies in the file, at most one applies in the machine.
#pragma once

#include <string>
#include <string_view>

#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

/// Whether the file `name` is a JFLAP file, by its ending or its root element.
bool is_jflap(std::string_view text, std::string_view name);

/// The equivalent machine file, for parse_machine(). `name` stands for the file in errors ("file:line: found …;
/// expected …") and names the machine.
Result<Json> machine_of_jflap(std::string_view text, const std::string& name);

}  // namespace continua
