// The text in a gzip file, read at any place without being held: in little time from a file in blocks
// (gzip_blocks.h), in somewhat more from any other.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <istream>
#include <memory>
#include <string>
#include <string_view>

#include "continua/core/result.h"

namespace continua {

/// Whether these are the first bytes of a gzip file.
bool begins_as_gzip(std::string_view bytes);
/// Whether there is a regular file that begins so.
bool is_gzip_file(const std::string& path);

class GzipText {
 public:
  /// The text of a file that stays open. Errors: it cannot be opened, or it is seen at once that it was cut, or that
  /// its text is much longer than any of ours.
  static Result<std::shared_ptr<const GzipText>> open(const std::string& path);
  /// The text of bytes that can be read at any place; `name` stands for the file.
  static Result<std::shared_ptr<const GzipText>> of(std::unique_ptr<std::istream> packed, const std::string& name);
  ~GzipText();
  GzipText(const GzipText&) = delete;
  GzipText& operator=(const GzipText&) = delete;

  /// Bytes of the text, fewer than asked for at its end; -1 on failure (unpacking_problem). Several threads may read.
  ssize_t read(std::uint64_t offset, char* into, std::size_t size) const;
  /// All of it, piece by piece. Error: why it cannot be read to its end.
  Outcome read_all(const std::function<void(std::string_view)>& use) const;

 private:
  class Held;
  GzipText(std::unique_ptr<Held> held, std::string name);

  const std::unique_ptr<Held> held_;
  const std::string name_;
};

/// The sentence on a reading that failed with this `errno`; empty if unpacking is not the reason.
std::string unpacking_problem(int error);

/// The text of a file, packed or not. Errors: those of read_file, or the packed bytes are damaged.
Result<std::string> read_text(const std::string& path);

/// Reads it from its beginning, and ends where it cannot be read any more.
std::unique_ptr<std::istream> stream_of(std::shared_ptr<const GzipText> text);

}  // namespace continua
