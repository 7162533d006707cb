// Words and gestures that are made together: one move of the human's (SEMANTICS.md §3, Ensembles).
#pragma once

#include "continua/perception/fusion.h"

namespace continua {

/// How long words without a told end, and gestures, wait for one another in a machine whose sentences wait for more
/// words (FusionWindow::pause_s).
inline constexpr double together_s = 0.4;

/// Whether the percept is a gesture that is shown with the words: it begins at most `together_s` before them, during
/// them, or so long after the beginning of words without a told end.
bool is_shown_with(const Percept& percept, const Percept& speech, const FusionWindow& window);

}  // namespace continua
