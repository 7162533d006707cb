// An utterance as a recogniser hears it.
#pragma once

#include "continua/core/random.h"
#include "continua/perception/input_event.h"
#include "continua/replay/noise/noise.h"

namespace continua {

/// Words are dropped, swapped and misheard, and the confidence is that of vary.h. False: nothing is heard. Without such
/// noise the utterance stays as it is.
bool hear_words(InputEvent& speech, const Noise& noise, Random& random);

/// The utterance becomes an n-best list of Noise::n_best: what was said at its place, and readings of it in which at
/// least one word is misheard. REQUIRES a word.
void hear_as_list(InputEvent& speech, const Noise& noise, Random& random);

}  // namespace continua
