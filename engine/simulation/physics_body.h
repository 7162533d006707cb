// The avatar's body in MuJoCo: commands become motions, and the world goes on by fixed steps while something moves.
#pragma once

#include <deque>
#include <memory>

#include "continua/body/body.h"
#include "continua/simulation/avatar.h"
#include "continua/simulation/physics.h"
#include "continua/simulation/scene.h"

namespace continua {

/// One act at a time, others wait in order, but for three things a person does not queue: a look or signal is done at
/// once; a reach or point takes the place of one that is under way (which is then reported done, with the reason that
/// it was superseded); and a stop ends at once what is under way and what waited before it. Physics is stepped only
/// while an act is under way or something moves; otherwise time jumps and a RestSpan tells so. Spans of successive
/// `advance`s adjoin. Should MuJoCo diverge, the act under way ends as dropped, its reason says so, and the world is
/// what it was when it was last at rest. The same commands at the same times give the same poses, bit for bit.
class PhysicsBody : public Body {
 public:
  /// Errors: the scene's avatar is incomplete.
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
