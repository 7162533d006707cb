// The human's latest pointing, by single samples.
#pragma once

#include <string>

#include "continua/perception/binding.h"

namespace continua {

struct Pointed {
  Vec3 place_W = Vec3::Zero();
  SimTime t;           ///< of the latest sample
  std::string object;  ///< the likeliest one there, or empty
};

/// Whether the pointing still counts at `t`: at most `before` after its latest sample.
inline bool goes_on(const Pointed& pointed, SimTime t, const FusionWindow& window) {
  return (t - pointed.t).seconds() <= window.before_s;
}

}  // namespace continua
