// Commands that are told to a person, to be typed.
#pragma once

#include <string>

namespace continua {

/// A word as a shell reads it: in quotation marks if it has to be.
inline std::string shell_word(const std::string& word) {
  if (!word.empty() && word.find_first_of(" '\"\\$&()*;<>?[]`|~#!") == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace continua
