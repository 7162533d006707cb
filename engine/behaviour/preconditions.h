// Preconditions of programs, from the affordances in voxemes, and the programs that bring them about. For example,
// H,hold(x,[1])->[lift([1])] and H->[grasp(x,[1])]hold(x,[1]) make grasping a precondition of lifting.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/behaviour/circumstances.h"
#include "continua/voxml/voxeme.h"

namespace continua {

/// An unmet condition, and the programs that result in it, in the order of the voxeme.
struct Outstanding {
  std::string condition;
  std::vector<Term> programs;
};

/// The first unmet condition of `program` with `object`. Nothing if there is none, or if one of several affordances has
/// all its conditions met. A condition that the world cannot tell counts as met.
std::optional<Outstanding> outstanding(const Term& program, const Term& object, const Voxeme& voxeme,
                                       const Circumstances& circumstances);

}  // namespace continua
