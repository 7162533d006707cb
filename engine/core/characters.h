// Text by its characters: Unicode code points in UTF-8.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace continua {

/// Length in bytes of the first character of `text`, 1 to 4; 0 if it does not begin with UTF-8.
std::size_t character_length(std::string_view text);

enum class CharacterKind { letter, digit, symbol, punctuation, space, invisible };

/// Kind of the first character of `text`, by its Unicode category. Marks count as letters, all numbers as digits.
/// Control characters are `space`, format characters `invisible`. Bytes that are not UTF-8, and an empty text, are
/// `invisible`.
CharacterKind kind_of(std::string_view text);

/// `text` for comparison without regard to case, in any alphabet: letters by their simple case folding, composed with
/// their marks (Unicode NFC). Bytes that are not UTF-8 stay. The result does not depend on a locale.
std::string folded(std::string_view text);

/// The characters of `text`, in order. A byte that is not UTF-8 stands for itself.
std::vector<std::string> characters(std::string_view text);

}  // namespace continua
