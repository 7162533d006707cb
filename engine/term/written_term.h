// The structure of a written term, without declared types of its names: for readers of logs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"
#include "continua/term/term.h"

namespace continua {

struct WrittenTerm {
  enum class Kind {
    name,    ///< name
    number,  ///< number
    text,    ///< 'a quoted text'
    place,   ///< place: <x, y, z>, all of them numbers
    list,    ///< parts: the elements
    call,    ///< name(a, b); name; parts: the arguments
    lambda,  ///< \x y. body; binders; parts: the body
    other,   ///< null, a truth, operators between operands, a function that is not a name; parts: its operands
  };
  Kind kind = Kind::other;
  std::string written;  ///< the text of the term
  std::string name;
  double number = 0;
  Place place;
  std::vector<std::string> binders;
  std::vector<WrittenTerm> parts;  ///< from left to right
};

/// Reads the notation of term_text.h. Errors are those of parse_term(), except errors of unknown names and of types.
Result<WrittenTerm> read_written_term(std::string_view text);

/// The last place in the term, from left to right; nullptr if there is none.
const Place* last_place(const WrittenTerm& term);

/// Whether `text` contains `name` as a whole word. The text may be several terms with other text between them.
bool mentions(std::string_view text, std::string_view name);

}  // namespace continua
