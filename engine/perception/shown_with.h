// Words and gestures that are made together: one move of the human's (SEMANTICS.md §3, Ensembles).
#pragma once

#include "continua/perception/fusion.h"

namespace continua {

/// Whether the percept is a gesture that is shown with the words: it begins before their told end, and they begin
/// before its own or within FusionWindow::together_s, in a machine whose sentences wait for more words
/// (FusionWindow::pause_s). A gesture that ends as it begins is made by itself.
bool is_shown_with(const Percept& percept, const Percept& speech, const FusionWindow& window);

}  // namespace continua
