// The standard output of a function, as text.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <iostream>
#include <string>
#include <utility>

namespace continua {

/// Takes standard output while it exists. A test's own messages go there too: check afterwards.

class StandardOutput {
 public:
  StandardOutput() {
    flush();
    kept_ = dup(STDOUT_FILENO);
    dup2(fileno(file_), STDOUT_FILENO);
  }
  ~StandardOutput() {
    flush();
    dup2(kept_, STDOUT_FILENO);
    close(kept_);
    std::fclose(file_);
  }
  StandardOutput(const StandardOutput&) = delete;
  StandardOutput& operator=(const StandardOutput&) = delete;

  std::string text() const {
    flush();
    std::string text(static_cast<std::size_t>(lseek(fileno(file_), 0, SEEK_END)), '\0');
    if (pread(fileno(file_), text.data(), text.size(), 0) < 0) text.clear();
    return text;
  }

 private:
  static void flush() {
    std::fflush(stdout);
    std::cout.flush();
  }
  std::FILE* file_ = std::tmpfile();
  int kept_ = -1;
};

/// The result of `run`, and its output.
template <class Run>
auto told(Run run) {
  const StandardOutput output;
  auto result = run();
  return std::pair(std::move(result), output.text());
}

}  // namespace continua
