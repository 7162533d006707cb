// A file that others read while it grows: a session's trace, its log, its recordings. Each piece is in the file as a
// whole, or not at all.
//
// A piece that was added is safe from the end of the program, however it ends; one that was synced, from the end of the
// machine as well.
#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

#include "continua/core/result.h"

namespace continua {

class GrowingFile {
 public:
  enum class Begin {
    anew,   ///< empty; a file that is there loses what it had
    first,  ///< there must be no file yet
    after,  ///< behind the present end of the file, which is made if it is not there
  };

  /// Where the file cannot be opened, all that follows fails.
  explicit GrowingFile(const std::string& path, Begin begin);
  /// Closes it.
  ~GrowingFile() { (void)close(); }
  GrowingFile(const GrowingFile&) = delete;
  GrowingFile& operator=(const GrowingFile&) = delete;

  /// Puts the piece behind the others. Error: nothing of it is in the file, and nothing comes after it any more.
  Outcome add(std::string_view piece);
  /// Pieces added before are on the disk. May be called while another thread adds, or closes the file. Error: they are
  /// not, and as nobody knows how much of it, nothing comes after it any more.
  Outcome sync();
  /// Syncs, and is done with the file. Closing again does nothing.
  Outcome close();

  /// Nothing has failed.
  bool sound() const { return problem_ == 0; }
  /// The fault, if something has failed.
  Error fault() const;
  /// The size of the whole pieces that were added.
  std::uint64_t bytes() const { return bytes_; }

 private:
  Outcome outcome() const;

  const std::string path_;
  std::uint64_t begin_ = 0, bytes_ = 0;
  int file_ = -1;
  std::mutex open_;  ///< held while the file must stay open, or is closed
  std::atomic<int> problem_ = 0;
};

}  // namespace continua
