// Lines of text that are wrapped at words.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace continua {

/// Columns that UTF-8 text takes, one for each character.
std::size_t columns_of(std::string_view text);

/// `text` behind `indent`, broken at spaces into lines of at most `width` columns where words allow; later lines stand
/// behind `hanging`. Ends with a line's end.
std::string wrapped(std::string_view text, std::string_view indent, std::string_view hanging, std::size_t width);

}  // namespace continua
