// Texts compressed as browsers take them.
#pragma once

#include <string>
#include <string_view>

namespace continua {

/// In the gzip format; `level` from 1, fast, to 9, small. Empty where there is no memory for it.
std::string gzipped(std::string_view text, int level = 1);

/// The unpacked bytes, as far as they can be read.
std::string gunzipped(std::string_view gzip);

}  // namespace continua
