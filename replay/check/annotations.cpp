#include "continua/replay/check/annotations.h"

#include <fmt/format.h>

#include "continua/replay/log/line_scan.h"

namespace continua {
namespace {

std::string escaped(std::string_view text, std::string_view characters) {
  std::string out;
  for (const char c : text) {
    if (characters.find(c) == std::string_view::npos)
      out += c;
    else
      out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return out;
}

// "12" off the end of "file:12"; nothing if there is no number, or nothing before it.
std::size_t take_number(std::string& where) {
  const auto colon = where.rfind(':');
  if (colon == std::string::npos || colon == 0) return 0;
  const auto number = number_in<std::size_t>(std::string_view(where).substr(colon + 1));
  if (!number || *number == 0) return 0;
  where.resize(colon);
  return *number;
}

std::string annotation(const FilePlace& place, const std::string& title, const std::string& message) {
  std::string properties = "file=" + github_property(place.file);
  if (place.line > 0) properties += fmt::format(",line={}", place.line);
  if (place.column > 0) properties += fmt::format(",col={}", place.column);
  return fmt::format("::error {},title={}::{}\n", properties, github_property(title), github_message(message));
}

}  // namespace

std::string github_message(std::string_view text) { return escaped(text, "%\r\n"); }

std::string github_property(std::string_view text) { return escaped(text, "%\r\n:,"); }

FilePlace place_of(const std::string& where) {
  FilePlace place{where, 0, 0};
  place.line = take_number(place.file);
  if (const auto line = take_number(place.file); line > 0) {
    place.column = place.line;
    place.line = line;
  }
  return place;
}

std::string github_annotations(const CheckCase& one) {
  if (one.status == exit_done) return {};
  const auto title = fmt::format("continua check: {}", one.verdict);
  if (one.problems.empty()) return annotation({one.path, one.line, 0}, title, one.sentence);
  std::string lines;
  for (const auto& problem : one.problems) {
    auto place = place_of(problem.where);
    if (place.file.empty()) place.file = one.path;
    lines += annotation(place, title, problem.sentence);
  }
  return lines;
}

}  // namespace continua
