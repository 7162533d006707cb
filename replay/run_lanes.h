// The whole run in columns: what the timeline and the list of records draw, so that a page need not fetch every record.
#pragma once

#include "core/located_json.h"
#include "core/result.h"
#include "replay/run_index.h"

namespace continua {

/// {
///   kinds: […], t: […], kind: […], cause: […], label: […]   one element a record (kind: place in kinds; cause: n or
///   -1;
///                                                           label: empty for poses and pointing samples)
///   interest: [n…]                     records worth stopping at
///   transitions: {n, id, from, to, input, depth: […]}
///   depth: [[t, n, depth]…]            where the stack's depth changed
///   speech, gesture: [[from, to, n, text]…]    the human's; an instant has from = to
///   pointing: [[from, to, n, samples]…]        bursts of samples less than half a second apart
///   utterance, move: [[t, n, text]…]           the avatar's speech and gestures; observed: another's, for comparison
///   act: [[from, to, n, program, status]…], rest: [[from, to, n]…]
///   flags: [[t, n, kind]…]             refusals (not of pointing samples), problems, unmet expectations
/// }
/// Times in seconds.
Result<Json> run_lanes(const RunIndex& run);

}  // namespace continua
