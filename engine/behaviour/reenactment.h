// What another avatar was observed to do, done again in a kinematic world.
#pragma once

#include <string>
#include <vector>

#include "continua/behaviour/performance.h"
#include "continua/body/kinematic_body.h"

namespace continua {

class Reenactment {
 public:
  /// `perspective` is whose sides place terms mean; `catalogue`, of voxemes, may be null and must outlive it.
  Reenactment(WorldSnapshot world, const Catalogue* catalogue, Perspective perspective)
      : body_(std::move(world), Occupied::cleared), performer_(catalogue, perspective) {}

  /// Does an act, a closed program, to its end at `t`, which never decreases: it has happened, so that there was room
  /// for it. Returns how it ended; what could not be done all the same leaves the world as it was.
  ActEnd act(const Term& program, SimTime t);

  const KinematicBody& body() const { return body_; }

 private:
  KinematicBody body_;
  Performer performer_;
  Performance performance_;
  int acts_ = 0;
};

}  // namespace continua
