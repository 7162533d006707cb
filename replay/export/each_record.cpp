#include "continua/replay/export/each_record.h"

#include <string_view>

namespace continua {

Outcome each_record(const RunIndex& run, const std::function<void(const Json& record)>& use) {
  Outcome broken;
  const auto read = [&](std::size_t n, std::string_view line) {
    const Json record = Json::parse(line, nullptr, false);
    if (!record.is_object()) {
      broken = Error{run.where(n), "is no JSON object"};
      return false;
    }
    use(record);
    return true;
  };
  if (auto problem = run.read_lines([](std::size_t n) { return n > 0; }, read)) return problem;
  return broken;
}

}  // namespace continua
