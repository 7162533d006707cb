#include "continua/replay/check/junit.h"

#include <algorithm>

#include <fmt/format.h>

namespace continua {
namespace {

// As the value of an attribute. XML has no way to write most control characters.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
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
