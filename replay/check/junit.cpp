#include "continua/replay/check/junit.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/core/markup.h"

namespace continua {

std::string junit_xml(const std::string& suite, const std::vector<JunitCase>& cases) {
  const auto failures =
      std::count_if(cases.begin(), cases.end(), [](const JunitCase& one) { return !one.failure.empty(); });
  const auto counts =
      fmt::format(R"(name="{}" tests="{}" failures="{}" errors="0")", in_markup(suite), cases.size(), failures);
  std::string xml =
      fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {}>\n  <testsuite {}>\n", counts, counts);
  for (const auto& [folder, name, failure] : cases) {
    xml += fmt::format(R"(    <testcase classname="{}" name="{}")", in_markup(folder), in_markup(name));
    xml += failure.empty() ? "/>\n"
                           : fmt::format(">\n      <failure message=\"{}\"/>\n    </testcase>\n", in_markup(failure));
  }
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace continua
