// The page's files, built into the program.
#pragma once

#include <span>
#include <string_view>

namespace continua {

/// A file of the page. Only its compressed bytes are held; `etag` is the SHA-256 of what they hold in hexadecimal, in
/// quotes.
struct WebAsset {
  std::string_view path;  ///< "/panels/graph.js"
  std::string_view mime;
  std::string_view etag;
  std::string_view gzip;
};

/// All of them, in order of their paths.
std::span<const WebAsset> web_assets();

}  // namespace continua
