// A packed text in pieces, each of which is unpacked without those before it. For gzip_text.cpp.
#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <optional>
#include <string>

#include "continua/core/result.h"

namespace continua {

struct GzipPiece {
  std::uint64_t offset = 0;  ///< in the whole text
  std::string text;
};

class GzipPieces {
 public:
  /// `packed`: can be read at any place. Errors: it is seen at once that they were cut off, or that they become longer
  /// than any of our texts.
  static Result<std::unique_ptr<GzipPieces>> of(std::unique_ptr<std::istream> packed, const std::string& name);

  virtual ~GzipPieces() = default;
  /// The piece with this byte of the text in it, an empty one behind its end; nothing and an errno on failure
  /// (unpacking_problem).
  virtual std::optional<GzipPiece> at(std::uint64_t offset) = 0;
};

}  // namespace continua
