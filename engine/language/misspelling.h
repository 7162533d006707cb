// How a word may come to be misspelt, letter by letter.
#pragma once

#include <string_view>

namespace continua {

/// The one mistake by which a word was written in place of another. Words in which more differs have no such mistake.
enum class Slip {
  none,       ///< more differs, or nothing
  exchanged,  ///< two neighbouring letters: "teh" for "the"
  missing,    ///< a letter, not the first: "blok" for "block"
  added,      ///< a letter, not in front: "putt" for "put"
  first,      ///< a letter is missing or added in front: "nife" for "knife"
  replaced    ///< a letter stands for another one: "lnife" for "knife"
};

/// The mistake that leads from the word that was meant to the written one. Both are in lower case. Letters are bytes,
/// so a mistake in a letter beyond ASCII may count as more than one.
Slip slip(std::string_view written, std::string_view meant);

/// Whether the mistake is one of the fingers, which seldom makes another word of the language: the reader need not ask.
bool is_of_the_fingers(Slip slip);

}  // namespace continua
