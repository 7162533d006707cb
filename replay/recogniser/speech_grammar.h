// A grammar for recognisers of speech, in JSGF: sentences built like a lexicon's examples, of the words of a scene.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"
#include "continua/language/lexicon.h"
#include "continua/world/world_snapshot.h"

namespace continua {

struct SpeechGrammarOptions {
  std::string name;                                          ///< of the grammar
  std::size_t patterns = 100;                                ///< the most; those that most examples have
  std::function<bool(const std::string& move)> is_taken;     ///< empty: all moves are
  std::function<bool(std::string_view word)> is_pronounced;  ///< whether the recogniser has the word; empty: it has all
};

struct SpeechGrammar {
  std::string text;
  std::size_t patterns = 0;
  std::set<std::string> words;         ///< single ones, that occur in it
  std::set<std::string> unpronounced;  ///< that were left out
};

/// An example's pattern is the sequence of its words' categories; a category stands for all of its words. So other
/// sentences of the pattern are understood as well, and a new noun or verb needs no example. Words for values that
/// nothing in the scene has are left out.
/// The error is the first problem of the examples.
Result<SpeechGrammar> speech_grammar(const std::shared_ptr<const Lexicon>& lexicon, const WorldSnapshot& world,
                                     const SpeechGrammarOptions& options);

}  // namespace continua
