// A trace read event by event: a long one takes no more memory than a short one.
#pragma once

#include <cstddef>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "continua/core/digest.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// Reads a trace once, from its first line to its last, whatever its faults.
class TraceReader {
 public:
  /// Reads the first line. `name` is the file's path as given.
  TraceReader(std::unique_ptr<std::istream> text, const std::string& name);

  /// The next event without faults; nothing at the end, or where the first line is of no trace.
  std::optional<TraceEvent> next();

  /// Its notes are those on the lines read so far; it has a digest at the end.
  const TraceHead& head() const { return head_; }
  /// Those of the lines read so far, in their order.
  const std::vector<Error>& problems() const { return problems_; }

 private:
  struct Line {
    std::string text;  // without \n or \r\n
    std::size_t number = 0;
    bool ends = false;  // with a newline
  };

  std::optional<Line> next_line();
  void refuse(const Line& line, const Error& error);
  void check_order(const TraceEvent& event);

  std::unique_ptr<std::istream> text_;
  RunningDigest digest_;
  std::size_t line_ = 0;
  TraceHead head_;
  std::vector<Error> problems_;
  struct Place {
    std::size_t line;
    SimTime t;
    bool is_end;
  };
  std::optional<Place> last_;  ///< of the event before
};

}  // namespace continua
