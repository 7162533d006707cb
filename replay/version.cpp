#include "replay/version.h"

#include <fmt/format.h>

#include "simulation/mujoco_version.h"

namespace continua {

std::string version_text() {
  return fmt::format("continua {}\nMuJoCo {}\n{}", CONTINUA_VERSION, mujoco_version(), CONTINUA_COMPILER);
}

std::string program_version() { return CONTINUA_VERSION; }

Json fingerprint() {
  return {{"mujoco", mujoco_version()}, {"compiler", CONTINUA_COMPILER}, {"arch", CONTINUA_ARCHITECTURE}};
}

}  // namespace continua
