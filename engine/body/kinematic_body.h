// The body without physics: every act succeeds at once. With it the engine runs, and is tested, without a simulator.
#pragma once

#include "continua/body/body.h"
#include "continua/body/placement.h"

namespace continua {

/// Acts are done as soon as time goes on, in order: the `advance` after their command ends at the time at which it
/// began. A stop leaves undone what was told before it since the last `advance`. Objects stand where acts leave them,
/// never in one another. What stands on or in an object moves along with it. What fits into a hollow on its end alone
/// is stood up, which the report tells; it lies again where it is put next. An act about something that is not in the
/// world is `unreachable`, one that cannot be done (no room, an object onto itself, a lift or move of nothing held) is
/// `blocked`; the world is then as before.
class KinematicBody : public Body {
 public:
  /// `cleared`: things are put just where the goal says, whatever is there, and push apart what they overlap then; a
  /// point always is.
  explicit KinematicBody(WorldSnapshot world, Occupied occupied = Occupied::avoided)
      : world_(std::move(world)), occupied_(occupied) {}

  void command(const AvatarCommand& command) override { waiting_.push_back(command); }
  WorldReport advance(SimTime t) override;
  WorldSnapshot snapshot() const override { return world_; }
  bool at_rest() const override { return waiting_.empty(); }

  /// Everything is as in the other world from now on, and nothing waits. Returns the poses that are others then.
  PoseSample become(const KinematicBody& other);

 private:
  /// Does the act and says how it went, but for its id and time.
  ActReport act(const AvatarCommand& command);
  ActReport move(const AvatarCommand& command);
  std::optional<Reason> turn(const AvatarCommand& command);
  /// The world with an object shaped as it lies, should it stand on its end.
  WorldSnapshot lying_down(const std::string& name) const;
  /// Shifts an object and all that stands on it.
  void shift(const std::string& object, const Vec3& by_W);
  /// How the objects lie that `before` has elsewhere.
  PoseSample moved_since(const WorldSnapshot& before) const;
  /// Lets go of what is held, which falls straight down.
  void release();

  WorldSnapshot world_;
  Occupied occupied_;
  std::map<std::string, ObjectState> lying_;  // those that stand on their end, as they were before
  std::vector<AvatarCommand> waiting_;
};

}  // namespace continua
