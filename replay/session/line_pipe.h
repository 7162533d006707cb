// A command that answers lines with lines, over its standard input and output.
#pragma once

#include <memory>
#include <string>

#include "continua/core/result.h"

namespace continua {

/// The command runs until the pipe is destroyed: its standard input ends then, and it is killed if it does not end
/// soon.
class LinePipe {
 public:
  /// Starts the command in a shell. Errors: it could not be started.
  static Result<std::unique_ptr<LinePipe>> open(const std::string& command);
  ~LinePipe();
  LinePipe(const LinePipe&) = delete;
  LinePipe& operator=(const LinePipe&) = delete;

  /// Sends a line, which has no end of its own, and waits for the line that answers it. Errors: the command ended, it
  /// did not answer within a minute, or its line is too long.
  Result<std::string> ask(const std::string& line);

 private:
  LinePipe(int socket, int process) : socket_(socket), process_(process) {}

  int socket_, process_;
  std::string received_;  ///< beyond the last answer
};

}  // namespace continua
