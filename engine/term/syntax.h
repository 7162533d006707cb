// The structure of a term's text, before its types are known. For parser, elaboration and written_term only.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"
#include "continua/term/term.h"

namespace continua {

struct Syntax {
  enum class Kind {
    literal,
    name,    ///< a bound variable or a constant
    lambda,  ///< of one variable; parts: the body
    apply,   ///< parts: the function, then one or more arguments
    list,    ///< parts: the elements
  };
  Kind kind = Kind::literal;
  std::size_t begin = 0;          ///< byte where it begins
  std::size_t from = 0, end = 0;  ///< its bytes [from, end), parentheses around it included
  Term literal;
  std::string name;       ///< of a name, or of a lambda's variable
  bool constant = false;  ///< a name that no variable is meant by: an operator, `quoted`
  bool bare = true;       ///< a name that stands without parentheses: box(…) is read as a literal, (box)(…) is not
  std::optional<Type> annotation;
  std::vector<Syntax> parts;
  std::size_t depth = 1;  ///< of the term it becomes

  // Found by the elaboration.
  std::optional<Type> type;  ///< of a lambda that of its variable, of a list that of its elements
  int bound = -1;            ///< index of the bound variable, -1 for a constant
};

/// No term that is read is deeper than this.
inline constexpr std::size_t deepest_term = 200;

/// Reads the notation of term_text.h. `base_types` are the names of base types an annotation may use.
Result<Syntax> parse_syntax(std::string_view text, const std::vector<std::string>& base_types);

}  // namespace continua
