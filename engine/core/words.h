// Splits text into words, in the same way for speech, lexicons and input symbols. For any alphabet that separates
// words.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace continua {

struct SpokenWord {
  std::string text;         ///< folded() letters, digits and apostrophes; "," for a comma
  bool comma = false;       ///< a comma, not a word
  bool ends_after = false;  ///< a sentence ends after it
  bool half = false;        ///< by a mark after which the sentence may go on: a colon, a semicolon, three dots
  bool quoted = false;      ///< within quotation marks that are closed
};

/// The words of `text`. Recognisers write no punctuation; if there is some, it is used.
///   letters, marks, digits  belong to words, and so do symbols beyond ASCII ("δ", "90°")
///   apostrophes             belong to a word that goes on with a letter: "don't" is one word; others are quotation
///   marks everything else         separates words; of punctuation, commas, ends of sentences and quotation marks are
///   reported
/// Invisible characters and bytes that are not UTF-8 are left out. At most `most` words are read, all if it is 0; `cut`
/// reports whether there were more.
std::vector<SpokenWord> words_of(std::string_view text, std::size_t most = 0, bool* cut = nullptr);

/// The words alone, without commas and apostrophes, joined with `separator`: "Don't, please!" is "dont please".
std::string bare_words(std::string_view text, std::string_view separator = " ");

}  // namespace continua
