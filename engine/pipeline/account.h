// Reports an ensemble and its understanding as engine events.
#pragma once

#include <vector>

#include "continua/pipeline/engine_state.h"

namespace continua {

/// The ensemble, with its pointings on the words of the utterance.
Attended account_of(const Ensemble& ensemble, const FusionWindow& window);

/// An `Understood` for each offer with a kind or words. The taken offer comes last, followed by its applications.
std::vector<EngineEvent> account_of(const std::vector<Offer>& offers, std::size_t taken);

}  // namespace continua
