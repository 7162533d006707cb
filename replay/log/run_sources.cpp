#include "continua/replay/log/run_sources.h"

#include <vector>

#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"

namespace continua {

std::optional<Error> RunSources::add(std::size_t n, const Json& record) {
  std::vector<std::size_t> open;
  const auto follow = [&](std::size_t at, const Json& of) {
    // A branch's record stands inside the one that tells of it.
    const auto& told = log::is<log::Branched>(run_.kind(at)) ? member_of(of, "record") : of;
    for (const auto& each : member_of(told, "because")) {
      if (!each.is_number_unsigned() || each.get<std::size_t>() >= at) continue;
      const auto source = each.get<std::size_t>();
      if (log::is<log::Input>(run_.kind(source)))
        inputs_.insert(source);
      else if (followed_.insert(source).second)
        open.push_back(source);
    }
  };
  follow(n, record);
  while (!open.empty()) {
    const auto at = open.back();
    open.pop_back();
    const auto of = run_.record(at);
    if (!of) return of.error();
    follow(at, *of);
  }
  return std::nullopt;
}

}  // namespace continua
