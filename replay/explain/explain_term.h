// Terms as logs write them, and their parts as texts, by which a derivation searches the log.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace continua {

/// `text` in its parts. All are empty but `whole` for a name, a number, a place, and text outside the notation.
struct TermParts {
  std::string whole;
  std::vector<std::string> binders;   ///< of \x v. body: x, v
  std::string body;                   ///< of a lambda
  std::string head;                   ///< of head(a, b); empty for a list
  std::vector<std::string> elements;  ///< of head(a, b) or [a, b]
};

TermParts term_parts(std::string_view text);

}  // namespace continua
