// The scene in MuJoCo, step by step: targets for the arm's servos, contacts, and the weld that holds objects.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "continua/simulation/avatar_form.h"
#include "continua/simulation/hand_path.h"
#include "continua/simulation/scene.h"

namespace continua {

/// Targets of the servos of arm and fingers in a step.
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
  /// speeds or accelerations beyond all measure); then only `restore` makes the world usable again.
  [[nodiscard]] bool step(const AvatarTarget& target);

  /// Keeps the present world for `restore`, in place of the one kept before. `create` keeps the first.
  void save();
  void restore();

  /// Sets the object (index into objects()) that the weld may hold, or -1. The weld holds exactly while both pads touch
  /// the object, and takes hold of it in its present pose, so that nothing jumps.
  void set_grip(int object);
  /// The object welded to the hand, or -1.
  int held() const;

  /// A pad touches the object, as of the last step.
  bool pad_touches(bool left, int object) const;
  /// Largest normal force, newtons, on `object` (for -1: on hand and fingers) from anything other than hand, fingers
  /// and held object.
  double outside_force(int object) const;

  /// Contacts of an object as of the last step: names of objects and `table`, sorted.
  std::vector<std::string> touched_by(int object) const;

  ArmVector hinges() const;
  Pose object_pose(int object) const;
  /// Names and poses of all bodies that can move.
  std::vector<std::pair<std::string, Pose>> poses() const;
  /// No joint is faster.
  bool slower_than(double m_per_s, double rad_per_s) const;
  /// No object is faster.
  bool objects_slower_than(double m_per_s, double rad_per_s) const;

  WorldSnapshot snapshot(SimTime t) const;

 private:
  struct State;
  explicit Physics(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace continua
