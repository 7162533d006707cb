// Compresses texts in a format that browsers read.
#pragma once

#include <string>
#include <string_view>

namespace continua {

/// `text` in the gzip format; `level` from 1, fast, to 9, small. Empty if there is not enough memory.
std::string gzipped(std::string_view text, int level = 1);

/// The uncompressed text, as far as it can be read.
std::string gunzipped(std::string_view gzip);

}  // namespace continua
