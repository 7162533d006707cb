// Speech as it is read: once, when it is perceived, in each of its recogniser's alternatives.
#pragma once

#include <memory>
#include <vector>

#include "continua/moves/understanding.h"
#include "continua/perception/fusion.h"

namespace continua {

/// One alternative of an utterance.
struct ReadSpeech {
  InputEvent event;
  Utterance utterance;
  std::vector<WordSpan> demonstratives;  ///< the words that pointing can go with
  std::vector<Taker> takers;             ///< the same words in time
};

struct Readings {
  std::shared_ptr<const Vocabulary> words;  ///< that speech was read with
  std::vector<ReadSpeech> alternatives;     ///< the event itself first
};

/// The readings of `speech`: `known`, unless that is null or the words have changed since.
std::shared_ptr<const Readings> readings_of(const InputEvent& speech, const Understanding& understanding,
                                            std::shared_ptr<const Readings> known = nullptr);

/// A pointing and the words that it goes with, counted in the utterance's words.
struct ShownWords {
  WordSpan words;
  Deixis pointing;
};

/// The ensemble's pointings on the words of one alternative. They were bound by the words of the first: other
/// alternatives have other words, and so may the same text once something was learned.
std::vector<ShownWords> shown_words(const ReadSpeech& speech, const Ensemble& ensemble, const FusionWindow& window);

}  // namespace continua
