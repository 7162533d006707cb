// How the engine tells of an ensemble and of what it was taken to mean.
#pragma once

#include <vector>

#include "continua/pipeline/engine_state.h"

namespace continua {

/// The ensemble, with its pointings on the words of what was said.
Attended account_of(const Ensemble& ensemble, const FusionWindow& window);

/// An `Understood` for each offer that says something, the one that was taken last, followed by what it applied.
std::vector<EngineEvent> account_of(const std::vector<Offer>& offers, std::size_t taken);

}  // namespace continua
