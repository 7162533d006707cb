// How an act came out, by its status in a log.
#pragma once

#include <string_view>

namespace continua::log {

/// Whether an act of this status ended without having been done, and not because it was given up.
constexpr bool has_failed(std::string_view status) {
  return status != "asked" && status != "started" && status != "done" && status != "stopped";
}

}  // namespace continua::log
