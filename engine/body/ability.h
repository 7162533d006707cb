// The ability of an arm, for a body without physics: which acts it can do where.
#pragma once

#include <optional>

#include "continua/body/avatar_command.h"
#include "continua/body/reason.h"
#include "continua/world/world_snapshot.h"

namespace continua {

class Ability {
 public:
  virtual ~Ability() = default;

  /// The reason why the arm cannot do the act in this world, as it would be told before anything moves; nothing if it
  /// can. REQUIRES that the world has all things of the command, and a place for its goal (body/placement.h). The hand
  /// is empty or holds the act's object.
  virtual std::optional<Reason> hindrance(const AvatarCommand& command, const WorldSnapshot& world) const = 0;

  /// Whether the hand gets to a point of the world.
  virtual bool reaches(const Vec3& p_W) const = 0;
};

}  // namespace continua
