// Files that a reader of the page hands over, in parts: run logs and traces.
#pragma once

#include <cstddef>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "continua/core/result.h"
#include "continua/replay/inspector/run_temporary.h"

namespace continua {

inline constexpr std::size_t most_dropped_bytes = std::size_t{64} << 20;  ///< of a file

/// A part of a file, as it comes.
struct DroppedPart {
  std::string key;   ///< of the file, the client's own: letters and digits
  std::string name;  ///< of the file, for people
  std::size_t part = 0;
  bool last = false;
  std::string_view bytes;
};

/// A file that has come whole.
struct DroppedFile {
  std::string folder, path;  ///< the folder has nothing else in it
  std::string name;          ///< fit for an address, without its ending
  bool is_trace = false;
};

/// Keeps parts until all are there. Few files at a time: one more lets go of that which was begun first. Safe to use
/// from several threads.
class DroppedFiles {
 public:
  explicit DroppedFiles(RunTemporary& temporary) : temporary_(temporary) {}

  /// Nothing until the last part. Errors: not the next part, too large, not a log or a trace, no more are taken.
  Result<std::optional<DroppedFile>> add(const DroppedPart& part);

 private:
  struct Coming {
    std::string key, folder, path;
    std::size_t parts = 0, bytes = 0;
  };
  Result<Coming> begin(const std::string& key);
  static Result<DroppedFile> whole(const Coming& coming, const std::string& name);

  RunTemporary& temporary_;
  std::mutex mutex_;  // guards the members below
  std::list<Coming> coming_;
  int begun_ = 0;
};

}  // namespace continua
