// The words known in a run: those of the lexicon and the scene, and names of programs and of things that the human
// taught.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "continua/language/vocabulary.h"
#include "continua/learning/learning.h"

namespace continua {

/// A value; copies share the vocabularies. Both are null for a machine without a lexicon.
struct KnownWords {
  std::shared_ptr<const Vocabulary> untaught;  ///< of the lexicon and the scene
  std::shared_ptr<const Vocabulary> all;       ///< with the names of `taught`
  std::map<std::string, Program, std::less<>> taught;
  std::map<std::string, Term, std::less<>> nouns;  ///< taught too
};

/// `world`: the scene with the words for its objects.
KnownWords known_words(const std::shared_ptr<const Lexicon>& lexicon, const WorldSnapshot& world);

/// The words after these lessons; the same vocabularies if no word was taught or forgotten.
KnownWords with_taught(KnownWords words, const Learned& learned);

}  // namespace continua
