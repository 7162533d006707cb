#include "continua/replay/terminal/terminal.h"

#include <fmt/format.h>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "continua/replay/trace/whole_file.h"

namespace continua {

namespace {

void print_line(const char* what, std::string line) {
  std::replace(line.begin(), line.end(), '\n', ' ');
  fmt::print(stderr, "continua: {}{}\n", what, line);
}

}  // namespace

void report(const Error& error) { print_line("", error.text()); }

void report_warning(const Error& warning) { print_line("warning: ", warning.text()); }

std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

int jobs_at_a_time(int jobs, const std::string& learned) {
  if (learned.empty() || jobs <= 1) return std::max(1, jobs);
  report({"--learned", "each trace begins with what the ones before it taught: one at a time, whatever -j says"});
  return 1;
}

Outcome write_file(const std::string& path, const std::string& content) {
  if (path == "-") {
    const bool written = std::fwrite(content.data(), 1, content.size(), stdout) == content.size();
    if (written && std::fflush(stdout) == 0) return std::nullopt;
    return Error{"standard output", fmt::format("cannot be written: {}", std::strerror(errno))};
  }
  return write_whole_file(path, content);
}

}  // namespace continua
