#include "continua/replay/check/junit.h"

#include <algorithm>

#include <fmt/format.h>

namespace continua {
namespace {

// Bytes of the letter in UTF-8 at that place; 0 for what is none.
std::size_t letter_at(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(at), second = byte(at + 1);
  const std::size_t size = first < 0x80   ? 1
                           : first < 0xC2 ? 0
                           : first < 0xE0 ? 2
                           : first < 0xF0 ? 3
                           : first < 0xF5 ? 4
                                          : 0;
  for (std::size_t i = 1; i < size; ++i)
    if ((byte(at + i) & 0xC0U) != 0x80) return 0;
  // Longer forms than needed, surrogates, and numbers beyond the last letter.
  const bool no_letter = (first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
                         (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90);
  return no_letter ? 0 : size;
}

// As the value of an attribute. XML has no way to write most control characters, nor bytes that are no UTF-8.
std::string escaped(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const auto size = letter_at(text, at);
    if (size != 1) {
      out += size == 0 ? "\uFFFD" : text.substr(at, size);
      at += std::max<std::size_t>(size, 1);
      continue;
    }
    const char c = text[at++];
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return out;
}

}  // namespace

std::string junit_xml(const std::string& suite, const std::vector<JunitCase>& cases) {
  const auto failures =
      std::count_if(cases.begin(), cases.end(), [](const JunitCase& one) { return !one.failure.empty(); });
  const auto counts =
      fmt::format(R"(name="{}" tests="{}" failures="{}" errors="0")", escaped(suite), cases.size(), failures);
  std::string xml =
      fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {}>\n  <testsuite {}>\n", counts, counts);
  for (const auto& [folder, name, failure] : cases) {
    xml += fmt::format(R"(    <testcase classname="{}" name="{}")", escaped(folder), escaped(name));
    xml += failure.empty() ? "/>\n"
                           : fmt::format(">\n      <failure message=\"{}\"/>\n    </testcase>\n", escaped(failure));
  }
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace continua
