// JSON pointers (RFC 6901), which name places in documents: "/transitions/3/when".
#pragma once

#include <string>
#include <string_view>

namespace continua {

/// `key` as one part of a pointer: '~' and '/' are escaped.
inline std::string pointer_part(std::string_view key) {
  std::string part;
  for (const char c : key) part += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return part;
}

}  // namespace continua
