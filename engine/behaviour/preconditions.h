// What has to hold before something can be done with an object, as its voxeme's affordances say, and what brings it
// about: H,hold(x,[1])->[lift([1])] and H->[grasp(x,[1])]hold(x,[1]) make grasping a precondition of lifting.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/behaviour/circumstances.h"
#include "continua/voxml/voxeme.h"

namespace continua {

/// A condition that does not hold, and the programs whose result it is, in the order of the voxeme.
struct Outstanding {
  std::string condition;
  std::vector<Term> programs;
};

/// The first condition that keeps `program` from being done with `object`; nothing if there is none, as where one of
/// several affordances has all it needs. What the world cannot tell is taken to hold.
std::optional<Outstanding> outstanding(const Term& program, const Term& object, const Voxeme& voxeme,
                                       const Circumstances& circumstances);

}  // namespace continua
