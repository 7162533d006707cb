// Moving one object once: which grip, by which way to which place, so that hand, arm and object find room. If they find
// none, what has to be moved aside first.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/simulation/grip_choice.h"
#include "continua/simulation/object_shape.h"
#include "continua/simulation/set_down.h"

namespace continua {

/// What shall be done with an object.
struct Task {
  std::string object;
  std::vector<std::string> parts;  ///< components by which it is best held, best first
  std::optional<Vec3> p_WG;        ///< where its centre shall come to lie; without it, the object is only held
  double raise_m = 0;              ///< and raised by so much
  double near_m = 0;               ///< how far from p_WG it may be set down
  std::string landmark = {};       ///< what must stay where it is, for the goal was said beside it; or empty
  std::string into = {};           ///< the container in whose hollow it shall be; or empty
  bool on_end = false;             ///< there it stands on its end
};

/// How the hand holds something.
struct Grasp {
  Pose X_WT;
  double opening_m = 0;  ///< of each finger before it closed
};

struct Handling {
  std::string object;
  Grip grip;
  std::optional<SetDown> set_down;
  std::string into;       ///< the container that it is set down in, or empty
  bool on_end = false;    ///< it is stood on its end
  bool has_room = false;  ///< nothing is in the way of hand and object
  bool reached = false;   ///< the arm gets to where the object is and goes
};

/// What the hand works with: the avatar, and things of known form.
struct Means {
  const AvatarForm& avatar;
  const ObjectShapes& shapes;
};

/// The grips there are where the task's object is: the one that holds it, or those that could take it.
std::vector<Grip> starts_of(const Task& task, const WorldSnapshot& world, const Means& means,
                            const std::optional<Grasp>& grasp);

/// Cost of a grip like one that has failed, in the unit of grip_choice.cpp: more than all costs of taste together, less
/// than the cost of a wrist at its limit.
inline constexpr double tried_cost = 5;

/// Whether two grips would fail alike.
bool alike(const Grip& a, const Grip& b);

/// The best handling, in `world` as it is. `grasp` is how the hand holds the object if it does, and is kept. Grips like
/// those `tried` before come last. Nothing if there is no way to hold the object.
std::optional<Handling> plan_handling(const Task& task, const WorldSnapshot& world, const Means& means,
                                      const std::optional<Grasp>& grasp, const std::vector<Grip>& tried);

/// What to move aside, and how, so that there is room for the task then: the object nearest to it that can be moved by
/// little, with room for the hand. If the task's object is in the hand, it may be that one, set down to be grasped
/// anew.
std::optional<Handling> make_room(const Task& task, const WorldSnapshot& world, const Means& means,
                                  const std::optional<Grasp>& grasp);

/// How to set down what is in the hand, `grasp`ed so, where it is in nobody's way: below, or nearby. Nothing if there
/// is no such place.
std::optional<Handling> set_aside(const std::string& held, const WorldSnapshot& world, const Means& means,
                                  const Grasp& grasp);

}  // namespace continua
