// Values of a log's lines as texts, without a tree where none is needed.
#pragma once

#include <string>
#include <string_view>

namespace continua {

/// What a value says, as it is written in a line: a string without its quotes and escapes, null nothing, all else as
/// compact JSON. What is no JSON is given as it stands.
std::string text_in(std::string_view value);

/// Whether that is the value as it stands between its quotes.
inline bool is_plain_text(std::string_view value) {
  return value.size() >= 2 && value.front() == '"' && value.find('\\') == std::string_view::npos;
}

}  // namespace continua
