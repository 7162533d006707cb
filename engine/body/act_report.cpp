#include "continua/body/act_report.h"

#include <array>

namespace continua {

std::string name_of(ActReport::Status status) {
  // In the order of the enumeration.
  constexpr std::array names = {"started", "done",        "missed",   "dropped",
                                "blocked", "unreachable", "unstable", "stopped"};
  static_assert(names.size() == static_cast<std::size_t>(ActReport::Status::stopped) + 1, "each status has a name");
  return names[static_cast<std::size_t>(status)];
}

}  // namespace continua
