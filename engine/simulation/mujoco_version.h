// The version of MuJoCo that the program runs with.
#pragma once

#include <string>

namespace continua {

/// As MuJoCo writes it: "2.2.2".
std::string mujoco_version();

}  // namespace continua
