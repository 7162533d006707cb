// The engine's account of an ensemble and of its meaning.
#pragma once

#include <vector>

#include "continua/pipeline/engine_state.h"

namespace continua {

/// The ensemble, with its pointings on the words of the utterance.
Attended account_of(const Ensemble& ensemble, const FusionWindow& window);

/// An `Understood` for each offer with content, the one that was taken last, followed by its applications.
std::vector<EngineEvent> account_of(const std::vector<Offer>& offers, std::size_t taken);

}  // namespace continua
