// The bytes of a run log: a file that stays open, or a text.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <memory>
#include <string>

namespace continua {

inline constexpr std::size_t block_bytes = std::size_t{1} << 20;  ///< read at once
inline constexpr auto file_changed = "cannot be read any more: the file has changed since it was opened";

class LogSource {
 public:
  virtual ~LogSource() = default;
  /// Bytes read, fewer than asked for at the end; -1 on failure. Leaves no position behind, so several threads may
  /// read.
  virtual ssize_t read(std::uint64_t offset, char* into, std::size_t size) const = 0;
};

std::shared_ptr<const LogSource> source_of_text(std::string text);

/// A file that stays open: a log replaced meanwhile goes on being the one that was scanned. Null if it cannot be read.
std::shared_ptr<const LogSource> source_of_file(const std::string& path);

}  // namespace continua
