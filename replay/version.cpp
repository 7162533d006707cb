#include "replay/version.h"

#include <fmt/format.h>
#include <Eigen/Core>

#include "simulation/mujoco_version.h"

namespace continua {

std::string version_text() {
  return fmt::format("continua {}\nMuJoCo {}\nEigen {}.{}.{}\n{}", CONTINUA_VERSION, mujoco_version(),
                     EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, CONTINUA_COMPILER);
}

}  // namespace continua
