// The index of a long log, kept next to it: a file that may be deleted at any time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "continua/replay/log/log_scan.h"

namespace continua {

/// A file as far as can be told without reading it: its size, when it was written, and its first and last bytes.
struct LogPrint {
  std::uint64_t bytes = 0;
  std::int64_t written_ns = 0;
  std::uint64_t ends = 0;
  bool operator==(const LogPrint&) const = default;
};

/// Nothing for a log so short that its index is not kept.
std::optional<LogPrint> print_of(const std::string& path);

/// The scan of the log at `path` as PATH.index has it, if the log is still the one of this print.
std::optional<ScannedLog> kept_scan(const std::string& path, const LogPrint& print);

/// Writes PATH.index. Without leave to write there it is not kept.
void keep_scan(const ScannedLog& log, const LogPrint& print);

}  // namespace continua
