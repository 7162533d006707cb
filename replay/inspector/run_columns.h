// The whole run in columns of numbers, for the timeline, the dialogue and the list of records. So a page of a million
// records need neither fetch nor parse each of them.
#pragma once

#include <string>

#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// Bytes: u32, little endian as all numbers, the length of a JSON header; the header; zeros up to a multiple of 8; then
/// the columns, each beginning at a multiple of 8 counted from there. The header:
///   {records, duration (seconds), kinds: […], names: […], complete,
///    columns: {NAME: {type: f64|f32|i32|u32|u16, offset: in bytes, length: in elements}}}
///
/// One element a record: `t` (seconds), `kind` (place in kinds), `cause` (n, or -1).
/// `stop`: n of the records worth stopping at: neither the stream of pointing samples nor its refusals, nor what it
/// moves without changing the stack. Lanes are LANE.n, LANE.from, LANE.to (seconds; an instant: equal), in the order of
/// the records that begin them:
///   speech, gesture         the human's; a gesture lasts to its stop, else to the next of its name and hand
///   pointing                bursts of samples less than half a second apart; pointing.count
///   utterance, move         the avatar's speech and gestures; observed: another's, for comparison
///   act                     from when it was asked for to its last state; act.status (place in names)
///   rest                    when nothing moved
///   flag                    refusals (not of pointing samples, nor of a gesture's end), problems, unmet expectations,
///   the ends of failed acts branches                of explored runs, while there is more than one; branches.count
///   confidence              of inputs that have one; confidence.value
///   depth                   of the stack, where it is known; depth.value
/// `step.n`, `step.id`, `step.from`, `step.to` (places in names), `step.depth`: of transitions.
Result<std::string> run_columns(const RunIndex& run);

}  // namespace continua
