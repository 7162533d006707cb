// Text by its characters: Unicode code points in UTF-8.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace continua {

/// Bytes of the first character of `text`, 1 to 4; 0 if it does not begin with UTF-8.
std::size_t character_length(std::string_view text);

enum class CharacterKind { letter, digit, symbol, punctuation, space, invisible };

/// Kind of the first character of `text`, by its Unicode category; marks count as letters, and so do numbers other than
/// digits as digits. Control and format characters are `space` and `invisible`. Bytes that are not UTF-8, and no text
/// at all, are `invisible`.
CharacterKind kind_of(std::string_view text);

/// `text` for comparison without regard to case, in any alphabet: every letter by its simple case folding, letters and
/// their marks composed (Unicode NFC). Bytes that are not UTF-8 stay. It depends on no locale.
std::string folded(std::string_view text);

/// The characters of `text`, in order. A byte that is not UTF-8 stands for itself.
std::vector<std::string> characters(std::string_view text);

}  // namespace continua
