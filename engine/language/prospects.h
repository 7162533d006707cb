// Which senses of the words of a sentence can have a part in a reading of it. A sense is left out if a phrase that it
// needs cannot be made of the words on that side, or if no other word takes the phrases that it makes: "by" has no part
// as "by the handle" where no verb takes a grip. Whatever is left out would be in no complete phrase, so the readings
// are the same; there are only fewer dead ends.
#pragma once

#include <vector>

#include "continua/language/lexicon.h"
#include "continua/language/reading.h"

namespace continua {

/// A sense of these words of the sentence.
struct PlacedSense {
  WordSpan words;
  const WordSense* sense;
};

/// For each of the senses, whether it can have a part.
std::vector<bool> with_prospects(const std::vector<PlacedSense>& senses, const Lexicon& lexicon);

}  // namespace continua
