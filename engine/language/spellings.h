// Short notation for many ways to say the same: "(can|could) you [please]".
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace continua {

/// The most ways that a text may stand for; a text for more stands for itself.
inline constexpr std::size_t most_spellings = 4000;

/// A text in this notation, taken apart: a word; parts one after another, of which there may be none; or a choice of
/// one among parts. A part that may be left out is a choice of it and of a sequence without parts.
struct Spelling {
  enum class Kind { word, sequence, choice };
  Kind kind = Kind::sequence;
  std::string_view word = {};  ///< within the text
  std::vector<Spelling> parts = {};
};

/// Takes a text apart. `|` separates alternatives, parentheses group them, and square brackets hold parts that may be
/// left out. Nothing if brackets do not match, fifty are within one another, or the text stands for more than
/// most_spellings.
std::optional<Spelling> read_spelling(std::string_view text);

/// The texts that `text` stands for, in their order, with single spaces between words: "a|b" is "a" and "b",
/// "(a|b) c [d]" is "a c d", "a c", "b c d" and "b c". A text that cannot be taken apart stands for itself.
std::vector<std::string> spellings(const std::string& text);

/// The words that `text` and what it stands for are made of, each as often as it is written.
std::vector<std::string_view> parts_of_spellings(std::string_view text);

}  // namespace continua
