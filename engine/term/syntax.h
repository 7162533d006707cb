// The structure of a term's text, before its types are known. For parser, elaboration, written_term and term_structure
// only.
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
  std::size_t begin = 0;          ///< its first byte
  std::size_t from = 0, end = 0;  ///< its bytes [from, end), with the parentheses around it
  Term literal;
  std::string name;       ///< of a name, or of a lambda's variable
  bool constant = false;  ///< a name that is never a variable: an operator, `quoted`
  bool bare = true;       ///< a name without parentheses: box(…) is read as a literal, (box)(…) is not
  std::optional<Type> annotation;
  std::vector<Syntax> parts;
  std::size_t depth = 1;  ///< depth of the resulting term

  // Found by the elaboration.
  std::optional<Type> type;  ///< for a lambda the type of its variable, for a list the type of its elements
  int bound = -1;            ///< index of the bound variable, -1 for a constant
};

/// The greatest depth of a term that is read.
inline constexpr std::size_t deepest_term = 200;

/// Reads the notation of term_text.h. `base_types`: the base types that an annotation may use.
Result<Syntax> parse_syntax(std::string_view text, const std::vector<std::string>& base_types);

}  // namespace continua
