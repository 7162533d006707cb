// Words and gestures that are made together: one move of the human's (SEMANTICS.md §3, Ensembles).
#pragma once

#include "continua/perception/fusion.h"

namespace continua {

/// Whether the percept is a gesture that is shown with the words: it begins with them or before their told end, in a
/// machine whose sentences wait for more words (FusionWindow::pause_s).
bool is_shown_with(const Percept& percept, const Percept& speech, const FusionWindow& window);

}  // namespace continua
