#include "continua/simulation/mujoco_version.h"

#include <mujoco/mujoco.h>

namespace continua {

std::string mujoco_version() { return mj_versionString(); }

}  // namespace continua
