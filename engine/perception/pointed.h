// Where the human pointed last, as single samples tell.
#pragma once

#include <string>

#include "continua/perception/binding.h"

namespace continua {

struct Pointed {
  Vec3 place_W = Vec3::Zero();
  SimTime t;           ///< of the latest sample
  std::string object;  ///< the likeliest one there, or empty
};

/// Whether an event at `t` belongs to that pointing: it follows the latest sample by no more than a pointing may
/// precede its words.
inline bool goes_on(const Pointed& pointed, SimTime t, const FusionWindow& window) {
  return (t - pointed.t).seconds() <= window.before_s;
}

}  // namespace continua
