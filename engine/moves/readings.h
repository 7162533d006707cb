// Readings of speech. Each of the recogniser's alternatives is read when the event is perceived, and again only when a
// word was learned since or another piece of the sentence came.
#pragma once

#include <memory>
#include <vector>

#include "continua/moves/understanding.h"
#include "continua/perception/fusion.h"

namespace continua {

/// One alternative of the utterance, as read.
struct ReadSpeech {
  InputEvent event;
  Utterance utterance;
  std::vector<Demonstrative> demonstratives;  ///< the words that pointing can go with
  std::vector<Taker> takers;                  ///< the same words in time
  SimTime until;                              ///< the end of its words
  bool ends_in_thing = false;                 ///< its last words may be a thing that is pointed at, too: is this block
};

struct Readings {
  std::shared_ptr<const Vocabulary> words;  ///< the vocabulary of these readings
  std::vector<ReadSpeech> alternatives;     ///< the event itself first
};

/// The readings of `speech`. Returns `known` unless it is null or the vocabulary has changed.
std::shared_ptr<const Readings> readings_of(const InputEvent& speech, const Understanding& understanding,
                                            std::shared_ptr<const Readings> known = nullptr);

/// Whether the last sentence may go on: it does not end with a mark, and is no whole sentence, such as "put the knife"
/// or "the red one", or its last words need a pointing, after which more words may come: "put it on this" [pointing]
/// "no, on this"; or its end may be the thing of which more is to come: "is this block", and then "red".
bool is_unfinished(const ReadSpeech& speech);

/// Whether the words of two utterances, read as a whole, make fewer moves or lose fewer words than apart.
bool reads_as_one(const Readings& first, const Readings& second, const Readings& whole);

/// A pointing and its words, counted in the words of the utterance.
struct ShownWords {
  WordSpan words;
  Deixis pointing;
};

/// The ensemble's pointings on the words of one alternative. Fusion bound them to the words of the first alternative.
/// Other alternatives have other words, and the same text may be read otherwise after a lesson.
std::vector<ShownWords> shown_words(const ReadSpeech& speech, const Ensemble& ensemble, const FusionWindow& window);

}  // namespace continua
