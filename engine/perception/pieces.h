// Pieces of speech: recognisers report a sentence in several events if its speaker pauses, as people do to point.
#pragma once

#include "continua/perception/input_event.h"

namespace continua {

/// The words of both events, at the times at which they were spoken. Of n-best lists each alternative is joined with
/// the other event's first; the whole is as certain as its less certain piece. REQUIRES speech, `first` before
/// `second`.
InputEvent joined(const InputEvent& first, const InputEvent& second);

}  // namespace continua
