// Short notation for many ways to say the same: "(can|could) you [please]".
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace continua {

/// The most ways that a text may stand for; a text for more stands for itself.
inline constexpr std::size_t most_spellings = 4000;

/// The texts that `text` stands for, in their order, with single spaces between words. `|` separates alternatives,
/// parentheses group them, and square brackets hold parts that may be left out: "a|b" is "a" and "b", "(a|b) c [d]" is
/// "a c d", "a c", "b c d" and "b c". A text with brackets that do not match stands for itself.
std::vector<std::string> spellings(const std::string& text);

/// The words that `text` and what it stands for are made of, each as often as it is written.
std::vector<std::string_view> parts_of_spellings(std::string_view text);

}  // namespace continua
