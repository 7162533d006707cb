// The way from an input to a record: the words and gestures, the transitions that fired and those that did not.
#pragma once

#include "continua/replay/explain/explain_scope.h"

namespace continua {

/// The inputs that contributed, in order: [{"n", "t", "kind": speech, gesture, pointing, act or another of the trace's,
/// "told", "here": whether it is the input that the record answers, "percepts": [records], "readings": [records],
/// "count", "until": of pointing samples, which are told together}].
Json explained_inputs(ExplainScope& scope);

/// The transitions in the chain, from the first: [{"n", "t", "step", "id", "from", "to", "input", "condition": of the
/// machine or null, "operation", "weight", "probability", "draw", "forced", "candidates", "gates" (as in RUNLOG.md),
/// "refused": [{"reason", "ids"}], those first that leave from fewest states, so the state's own}]. `graph` is the
/// header's.
Json explained_steps(ExplainScope& scope, const Json& graph);

/// [{"reason", "ids"}] for the `refused` of a transition or refusal, in the order of explained_steps.
Json explained_refusals(const Json& record, const Json& graph);

/// The immediate consequences of record n: [{"n", "kind", "brief"}] of the records whose cause is n, in order.
Json brought_about(ExplainScope& scope, std::size_t n);

/// An operation of the log in words: "push command ← meaning, candidates ← choices", "pop 1", "nothing".
std::string operation_text(const Json& operation);

}  // namespace continua
