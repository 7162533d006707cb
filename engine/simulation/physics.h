// The scene in MuJoCo, one step at a time: what the arm's servos are told, what touches what, and the weld that holds.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "continua/simulation/avatar_form.h"
#include "continua/simulation/hand_path.h"
#include "continua/simulation/scene.h"

namespace continua {

/// What the servos of arm and fingers are told in a step.
struct AvatarTarget {
  HingeTarget hinges;
  double opening_m = 0;  ///< of each finger, from the middle
};

class Physics {
 public:
  /// Errors: the scene lacks an element of the avatar.
  static Result<std::unique_ptr<Physics>> create(const Scene& scene);
  ~Physics();

  double timestep_s() const;
  const AvatarForm& avatar() const;
  const Arm& arm() const { return avatar().arm; }
  const std::vector<SceneObject>& objects() const;

  /// One step of fixed length. No pose is ever written: things move by forces. False if MuJoCo diverged (positions,
  /// speeds or forces beyond all measure): only `restore` then makes the world usable again.
  [[nodiscard]] bool step(const AvatarTarget& target);

  /// Keeps the world as it is, for `restore`. Anew at every call; once at the beginning.
  void save();
  void restore();

  /// Which object (index into objects()) the weld may hold, or -1. It holds while both pads touch it, and only then; it
  /// takes hold where the object is, so that nothing jumps.
  void set_grip(int object);
  /// The object welded to the hand, or -1.
  int held() const;

  /// What the pads touch, as of the last step.
  bool pad_touches(bool left, int object) const;
  /// Largest normal force, newtons, between `object` (or, for -1, hand and fingers) and anything but hand, fingers and
  /// what is held.
  double outside_force(int object) const;

  /// What an object touches, as of the last step: other objects and, in the order of names among them, `table`.
  std::vector<std::string> touched_by(int object) const;

  ArmVector hinges() const;
  Pose object_pose(int object) const;
  /// Of every body that can move, by name.
  std::vector<std::pair<std::string, Pose>> poses() const;
  /// Nothing turns or moves faster than these.
  bool slower_than(double m_per_s, double rad_per_s) const;
  /// No object does.
  bool objects_slower_than(double m_per_s, double rad_per_s) const;

  WorldSnapshot snapshot(SimTime t) const;

 private:
  struct State;
  explicit Physics(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace continua
