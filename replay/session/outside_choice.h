// Policies from outside of the engine that choose among transitions: a command that is asked over a pipe, and the
// choices of an earlier run, which replay its run without the command. POLICY.md has the lines of the pipe.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "continua/automaton/choice.h"
#include "continua/automaton/machine.h"
#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

/// Whether the text names such a policy: "pipe:COMMAND" or "run:RUN.run.jsonl".
bool is_outside_choice(std::string_view text);

struct OutsideChoice {
  std::shared_ptr<OutsidePolicy> policy;
  std::string told;  ///< as a run log's header has it; of "run:…", where that run was a command's, as in its header
};

/// The policy that the text names. A command starts when a run begins. Errors: there is no such run log, or it is of
/// another machine. REQUIRES is_outside_choice().
Result<OutsideChoice> open_outside_choice(const std::string& text, std::shared_ptr<const Machine> machine);

/// A question to a command, as POLICY.md describes it.
Json question_of(const OpenChoice& open, const Machine& machine);

}  // namespace continua
