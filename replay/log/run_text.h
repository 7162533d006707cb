// Values of a log's lines as texts, without a tree where none is needed.
#pragma once

#include <string>
#include <string_view>

namespace continua {

/// A value in the form in which it stands in a line: a string without its quotes and escapes, null as nothing, all else
/// as compact JSON. A value that is no JSON is given as it stands.
std::string text_in(std::string_view value);

/// Whether that is the value as it stands between its quotes.
inline bool is_plain_text(std::string_view value) {
  return value.size() >= 2 && value.front() == '"' && value.find('\\') == std::string_view::npos;
}

}  // namespace continua
