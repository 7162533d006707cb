#include "continua/pipeline/account.h"

#include <utility>

namespace continua {

Attended account_of(const Ensemble& ensemble, const FusionWindow& window) {
  const auto& percept = ensemble.percept;
  Attended attended{percept.serial, percept.event.t, ensemble.at, {}, percept.pieces, {}, percept.assured};
  if (!percept.pieces.empty()) attended.text = percept.event.text;
  if (!percept.readings) return attended;
  const auto& speech = percept.readings->alternatives.front();
  const auto begin = speech.utterance.words.begin();
  for (auto& [span, pointing] : shown_words(speech, ensemble, window))
    attended.bound.push_back(
        {{begin + static_cast<std::ptrdiff_t>(span.begin), begin + static_cast<std::ptrdiff_t>(span.end)},
         std::move(pointing)});
  return attended;
}

std::vector<EngineEvent> account_of(const std::vector<Offer>& offers, std::size_t taken) {
  std::vector<EngineEvent> events;
  const auto tell = [&](std::size_t k) {
    const auto& offer = offers[k];
    if (offer.move.kind.empty() && offer.move.words.empty() && !offer.move.shape) return;
    events.push_back(Understood{offer.move, offer.input.because,
                                offers.size() > 1 ? std::optional(offer.alternative) : std::nullopt,
                                offer.input.confidence, k == taken});
    if (k == taken) events.insert(events.end(), offer.applied.begin(), offer.applied.end());
  };
  for (std::size_t k = 0; k < offers.size(); ++k)
    if (k != taken) tell(k);
  tell(taken);
  return events;
}

}  // namespace continua
