// Text as words. Recognisers write no punctuation at all; where there is some, it helps.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace continua {

struct SpokenWord {
  std::string text;         ///< ASCII letters in lower case
  bool comma = false;       ///< a comma, not a word; its text is ","
  bool ends_after = false;  ///< a sentence ends after it
};

/// Words are what stands between spaces and punctuation; apostrophes and characters beyond ASCII are parts of words,
/// bytes that are not UTF-8 are left out. At most `most` words are read, all if it is 0; `cut` tells whether there were
/// more.
std::vector<SpokenWord> words_of(std::string_view text, std::size_t most = 0, bool* cut = nullptr);

}  // namespace continua
