// Names of files that hold a text packed with gzip: that of the text, and ".gz".
#pragma once

#include <string_view>

namespace continua {

inline constexpr std::string_view gzip_ending = ".gz";

/// Whether what is written under this name is packed. Whether a file that is read is packed, its first bytes tell.
inline bool is_gzip_name(std::string_view path) { return path.ends_with(gzip_ending); }

/// The name of the text.
inline std::string_view without_gzip_ending(std::string_view path) {
  return is_gzip_name(path) ? path.substr(0, path.size() - gzip_ending.size()) : path;
}

}  // namespace continua
