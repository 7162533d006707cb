// Text without the blanks around it.
#pragma once

#include <string_view>

namespace continua {

/// The part of `text` without the characters of `blanks` at its ends; empty if it has no others.
inline std::string_view trimmed(std::string_view text, std::string_view blanks = " \t\r\n") {
  const auto from = text.find_first_not_of(blanks);
  return from == std::string_view::npos ? std::string_view()
                                        : text.substr(from, text.find_last_not_of(blanks) + 1 - from);
}

}  // namespace continua
