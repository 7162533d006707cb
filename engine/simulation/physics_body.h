// The avatar's body in MuJoCo: commands become motions, and physics steps while something moves.
#pragma once

#include <deque>
#include <memory>

#include "continua/body/body.h"
#include "continua/simulation/avatar.h"
#include "continua/simulation/physics.h"
#include "continua/simulation/scene.h"

namespace continua {

/// One act runs at a time, and others wait in order, with three exceptions. A look or signal is done at once. A reach
/// or point supersedes another one under way, which ends as done. A stop ends the act under way and cancels the acts
/// before the stop.
///
/// Physics steps only while an act is under way or something moves. Otherwise time jumps, and a RestSpan reports the
/// jump; spans of successive `advance`s adjoin. If MuJoCo diverges, the act under way ends as dropped, and the world
/// returns to its last rest. The same commands at the same times give the same poses, bit for bit.
class PhysicsBody : public Body {
 public:
  /// Errors: the scene's avatar is incomplete; its physics is too slow (world_pace.h).
  static Result<std::unique_ptr<PhysicsBody>> create(const Scene& scene);

  void command(const AvatarCommand& command) override;
  WorldReport advance(SimTime t) override;
  WorldSnapshot snapshot() const override;
  bool at_rest() const override;

 private:
  explicit PhysicsBody(std::unique_ptr<Physics> physics);

  bool is_still() const;
  void set_back();
  bool begin_acts(WorldReport& report);
  void begin_stop(WorldReport& report, SimTime t);
  void begin_act(const AvatarCommand& command, WorldReport& report, SimTime t);
  bool finish_act(WorldReport& report, SimTime t);
  void sample(WorldReport& report);

  std::unique_ptr<Physics> physics_;
  Avatar avatar_;
  SimTime step_, now_, told_until_;  // now_ lags told_until_ by less than a step while things move
  std::deque<AvatarCommand> waiting_;
  int act_id_ = 0;       // of the act under way
  int still_steps_ = 0;  // for how long nothing has moved
  std::optional<SimTime> last_sample_;
  std::map<std::string, Pose> last_poses_;
};

}  // namespace continua
