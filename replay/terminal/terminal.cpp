#include "continua/replay/terminal/terminal.h"

#include <unistd.h>

#include <fmt/format.h>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "continua/core/replaced_file.h"

namespace continua {

namespace {

bool is_control(unsigned char letter) { return letter < ' ' && letter != '\n' && letter != '\t'; }

// Bytes of a sequence that sets a colour or the weight of letters, of which only "conceal" (8) hides something.
std::size_t colour_at(const std::string& text, std::size_t at) {
  if (text.compare(at, 2, "\x1b[") != 0) return 0;
  const auto end = text.find_first_not_of("0123456789", at + 2);
  const auto digits = end == std::string::npos ? 0 : end - at - 2;
  return digits < 1 || digits > 2 || text[end] != 'm' || text[at + 2] == '8' ? 0 : digits + 3;
}

void print_line(const char* what, const std::string& line) {
  put(stderr, fmt::format("continua: {}{}\n", what, printable_line(line)));
}

}  // namespace

void put(std::FILE* stream, const std::string& text) {
  [[maybe_unused]] const auto written = std::fwrite(text.data(), 1, text.size(), stream);
}

std::string printable(const std::string& text) {
  std::string shown;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto letter = static_cast<unsigned char>(text[i]);
    // U+0080 to U+009F, in UTF-8: terminals obey them as well.
    if (const auto colour = colour_at(text, i); colour > 0) {
      shown += text.substr(i, colour);
      i += colour - 1;
      continue;
    }
    const bool wide = letter == 0xc2 && i + 1 < text.size() && static_cast<unsigned char>(text[i + 1]) < 0xa0;
    if (wide)
      shown += fmt::format("\\u{:04x}", static_cast<unsigned char>(text[++i]));
    else if (is_control(letter) || letter == 0x7f)
      shown += fmt::format("\\u{:04x}", letter);
    else
      shown += text[i];
  }
  return shown;
}

std::string printable_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return printable(text);
}

void report(const Error& error) { print_line("", error.text()); }

void report_warning(const Error& warning) { print_line("warning: ", warning.text()); }

std::string verdict_word(const std::string& word, bool good) {
  const auto* refused = std::getenv("NO_COLOR");
  if ((refused && *refused) || !isatty(STDOUT_FILENO)) return word;
  return fmt::format("\033[{}m{}\033[0m", good ? 32 : 31, word);
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
  return replace_file(path, content);
}

}  // namespace continua
