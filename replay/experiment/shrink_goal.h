// The goal that a trace must still meet while it is made smaller.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/replay/session/expectation.h"
#include "continua/replay/session/session.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// One of these:
/// - a situation: fields of an `expect` event, all of which are met at some instant of the run, once an input has been
///   attended to or an act has ended;
/// - an expectation of the trace that is not met, and finds the same;
/// - an input that is refused, the same one in the same state;
/// - a problem that is reported, the same one.
/// - a difference from another run, with the same cause (replay/experiment/shrink_against.h).
/// The three before the last are pinned to the first of the run of the whole trace, or to that of a line of it.
struct ShrinkGoal {
  std::optional<Expectation> situation;
  std::string kind;                 ///< of the record that is looked for: `expect`, `refusal`, `problem`; or `changed`
  std::optional<std::size_t> line;  ///< of the trace, of which that record must come
  std::string text;                 ///< as it was asked for
};

/// From a person's text: `state=Ask` and the like, several of which make one situation, the same as a JSON object, or
/// `unmet`, `refusal`, `problem`, each alone or with `:LINE`, or `changed`.
Result<ShrinkGoal> parse_goal(const std::vector<std::string>& texts);

/// Whether an `expect` event would be met; for `says` words before the last utterance since the input count too.
bool meets(const Expectation& expectation, const Situation& situation);

/// A record of a run that a goal can be pinned to.
struct Finding {
  std::optional<std::size_t> line;  ///< of the input that it came of, or its own
  Json what;                        ///< the content that must be the same
  SimTime t;
};

/// The records of a run log that a goal of this kind looks for, in order; of expectations those not met.
std::vector<Finding> findings(std::string_view log, const std::string& kind);

}  // namespace continua
