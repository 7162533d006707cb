// The body without physics: every act succeeds at once. With it the engine runs, and is tested, without a simulator.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "continua/body/ability.h"
#include "continua/body/body.h"
#include "continua/body/placement.h"

namespace continua {

/// Acts are done in order while time stands still, unless they are held. An `advance` reports that an act has begun,
/// and the next one does it; an act that is impossible begins and fails in one. A stop cancels all acts commanded
/// before it. Objects stay where acts leave them and never overlap. Things on or in an object move along with it. An
/// object that fits into a hollow only on its end is stood up, and the report says so; it lies again at its next place.
/// An act about a missing thing or beyond the arm's ability is `unreachable`. An act without room, onto the object
/// itself, or with nothing in the hand is `blocked`. After either the world is as before.
class KinematicBody : public Body {
 public:
  /// With `cleared` an object comes to the exact place of its goal and pushes other things apart. A point is always
  /// treated so.
  /// `ability` tells which acts the arm can do; without it the arm is everywhere at once.
  explicit KinematicBody(WorldSnapshot world, Occupied occupied = Occupied::avoided,
                         std::shared_ptr<const Ability> ability = nullptr)
      : world_(std::move(world)), occupied_(occupied), ability_(std::move(ability)) {}

  void command(const AvatarCommand& command) override { waiting_.push_back(command); }
  WorldReport advance(SimTime t) override;
  void hold(bool held) override { held_ = held; }
  WorldSnapshot snapshot() const override { return world_; }
  bool at_rest() const override { return waiting_.empty(); }

  /// Copies the other world and cancels all waiting acts. Returns the poses that changed.
  PoseSample become(const KinematicBody& other);

 private:
  /// Whether nothing is to be done now.
  bool waits() const;
  /// Takes the commands before the last stop off the queue, and reports them as stopped.
  void give_up_stopped(WorldReport& report);
  /// An act that was tried: its report, and the world after it.
  struct Tried {
    ActReport end;
    WorldSnapshot world;
    std::map<std::string, ObjectState> lying;
  };
  Tried tried(const AvatarCommand& command) const;
  /// Does the act. The report lacks id and time.
  ActReport act(const AvatarCommand& command);
  OrReason<Placement> place_of(const AvatarCommand& command, const WorldSnapshot& world) const;
  std::optional<Reason> hindrance(const AvatarCommand& asked) const;
  ActReport move(const AvatarCommand& command);
  std::optional<Reason> turn(const AvatarCommand& command);
  /// The world in which the object lies, even if it stands on its end now.
  WorldSnapshot lying_down(const std::string& name) const;
  /// Shifts an object and everything on it.
  void shift(const std::string& object, const Vec3& by_W);
  /// Poses of the objects that moved since `before`.
  PoseSample moved_since(const WorldSnapshot& before) const;
  /// Lets go of the held object, which falls straight down.
  void release();

  WorldSnapshot world_;
  Occupied occupied_;
  std::shared_ptr<const Ability> ability_;
  std::map<std::string, ObjectState> lying_;  // objects on their end, as they lay before
  std::deque<AvatarCommand> waiting_;
  std::optional<Tried> begun_;  // the first of them: it was reported, and comes about in the next advance
  bool held_ = false;           // begun_ does not come about yet
};

}  // namespace continua
