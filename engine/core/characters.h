// Text by its characters: Unicode code points in UTF-8.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace continua {

/// Bytes of the first character of `text`, 1 to 4; 0 if it does not begin with UTF-8.
std::size_t character_length(std::string_view text);

/// The characters of `text`, in order. A byte that is not UTF-8 stands for itself.
std::vector<std::string> characters(std::string_view text);

}  // namespace continua
