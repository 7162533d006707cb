// Observed acts of another avatar, done again in a kinematic world.
#pragma once

#include <string>
#include <vector>

#include "continua/behaviour/performance.h"
#include "continua/body/kinematic_body.h"

namespace continua {

class Reenactment {
 public:
  /// Sides in place terms are those of `perspective`. `catalogue`, of voxemes, may be null and must outlive it.
  Reenactment(WorldSnapshot world, const Catalogue* catalogue, Perspective perspective)
      : body_(std::move(world), Occupied::cleared), performer_(catalogue, perspective) {}

  /// Does an act, a closed program, to its end at `t`, which never decreases. There is always room, since the act
  /// really happened. Returns the end of the act; a failed act leaves the world as it was.
  ActEnd act(const Term& program, SimTime t);

  const KinematicBody& body() const { return body_; }

 private:
  KinematicBody body_;
  Performer performer_;
  Performance performance_;
  int acts_ = 0;
};

}  // namespace continua
