#include "continua/core/counted.h"

#include <fmt/format.h>

namespace continua {

std::string counted(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace continua
