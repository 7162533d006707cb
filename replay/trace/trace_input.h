// The events of a trace that are inputs, from and to JSON: speech, gestures, samples of pointing (FORMAT.md).
#pragma once

#include "continua/replay/trace/trace_fields.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// `t`: when the event became known. Problems go where `fields` puts them; such an event is not to be used.
InputEvent read_speech(const TraceFields& fields, SimTime t);
InputEvent read_gesture(const TraceFields& fields, SimTime t);
InputEvent read_pointing(const TraceFields& fields, SimTime t);
InputEvent read_gaze(const TraceFields& fields, SimTime t);

/// Adds the fields of an event that is an input.
void put_input_event(Json& json, const TraceEvent& event);

}  // namespace continua
