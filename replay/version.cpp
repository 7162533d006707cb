#include "replay/version.h"

#include <fmt/format.h>

#include "simulation/mujoco_version.h"

namespace continua {

std::string version_text() {
  return fmt::format("continua {}\nMuJoCo {}\n{}", CONTINUA_VERSION, mujoco_version(), CONTINUA_COMPILER);
}

}  // namespace continua
