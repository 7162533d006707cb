// Inputs that the recogniser is not sure of. They wait, and the machine is offered `unsure` in their place, so that the
// avatar can ask about them (automaton/FORMAT.md, Confidence).
#pragma once

#include <optional>
#include <vector>

#include "continua/pipeline/engine.h"

namespace continua {

/// Whether two answers of the engine differ in the acts asked for, in the state or on the stack. Other traces of an
/// input, such as utterances and registers, do not count.
bool lead_elsewhere(const Tick& a, const Tick& b);

bool is_refused(const Tick& tick);

/// The input `unsure` about these offers, the first of which counts most, and the state in which they wait.
struct Doubt {
  EngineState state;
  Input input;
};
Doubt doubt_of(EngineState state, const Ensemble& ensemble, const std::vector<Offer>& offers,
               const std::vector<std::size_t>& doubted);

/// Attends next to the input that waits under this number, as if it were sure; 0 is the move under way, as it is, and
/// the rest of its utterance.
Tick attend_again(EngineState state, const Reattended& again);

/// Whether this move, the latest of the utterance under way, is attended to again next. The rest of the utterance then
/// follows it there.
bool comes_again(EngineState& state, const Offer& move);

}  // namespace continua
