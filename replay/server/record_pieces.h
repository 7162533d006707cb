// A session's log in pieces for many listeners, each of which reads at its own speed: what one has read is there for
// the next.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace continua {

/// Server-sent events, or a part of them, as a chunk of an answer.
std::string chunk_of(std::string_view text);
std::string event_text(std::string_view name, std::string_view data);

/// A place in a log between two lines.
struct LogPlace {
  std::uint64_t bytes = 0, record = 0;  ///< before it
  bool operator==(const LogPlace&) const = default;
};

struct RecordPiece {
  LogPlace begin, end;
  std::uint64_t from = 0;                    ///< the records before are left out
  std::shared_ptr<const std::string> chunk;  ///< an event for each record; null: all are left out
};

/// For use by one thread.
class RecordPieces {
 public:
  explicit RecordPieces(const std::string& log_path);
  ~RecordPieces();
  RecordPieces(const RecordPieces&) = delete;
  RecordPieces& operator=(const RecordPieces&) = delete;

  /// The lines behind `begin`, at most up to `bytes` and about a megabyte of them, without those before record `from`.
  /// Null: the log has no whole line there.
  std::shared_ptr<const RecordPiece> at(const LogPlace& begin, std::uint64_t bytes, std::uint64_t from);

 private:
  std::string lines(std::uint64_t begin, std::uint64_t end) const;

  int file_;
  std::shared_ptr<const RecordPiece> last_;
};

}  // namespace continua
