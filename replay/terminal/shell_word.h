// Commands that are shown to a person, to be typed.
#pragma once

#include <string>

namespace continua {

/// `word` as a shell reads it: in quotation marks where it needs them.
std::string shell_word(const std::string& word);

}  // namespace continua
