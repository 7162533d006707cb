// The run log of a live session: a file that others read while it is written, line by line.
#pragma once

#include <cstdint>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "continua/core/growing_file.h"

namespace continua {

/// Whether a record of this kind tells a deed of the avatar: its words, its gestures, its acts.
bool is_avatars_move(std::string_view kind);

class LiveLog : private std::streambuf {
 public:
  explicit LiveLog(const std::string& path) : file_(path, GrowingFile::Begin::anew), stream_(this) {}

  /// Where whole lines are written to; each is in the file when it has been written.
  std::ostream& stream() { return stream_; }
  /// All that was written is in the file.
  bool sound() const { return file_.sound(); }
  /// It is on the disk from then on.
  void close() { (void)file_.close(); }
  /// Whole lines in the file. A line that did not fit is not in it.
  std::uint64_t bytes() const { return file_.bytes(); }

  /// The avatar's moves that were written since they were last taken, as lines without their newline.
  std::vector<std::string> take_moves() { return std::exchange(moves_, {}); }

 private:
  std::streamsize xsputn(const char* line, std::streamsize size) override;

  GrowingFile file_;
  std::ostream stream_;
  std::vector<std::string> moves_;
};

}  // namespace continua
