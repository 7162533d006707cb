// Moving one object once: the choice of grip, way and place with room for hand, arm and object. Without room,
// the choice of a thing to move aside first.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/body/avatar_command.h"
#include "continua/simulation/grip_choice.h"
#include "continua/simulation/object_shape.h"
#include "continua/simulation/set_down.h"

namespace continua {

/// The task of a handling.
struct Task {
  std::string object;
  std::vector<std::string> parts;     ///< components to hold it by, best first
  std::optional<Vec3> p_WG;           ///< goal of its centre; if absent, the object is only held
  double raise_m = 0;                 ///< rise of the held object
  double near_m = 0;                  ///< greatest distance from p_WG
  std::string landmark = {};          ///< the goal is relative to this, so it must stay; or empty
  std::string into = {};              ///< the container to put it in; or empty
  bool on_end = false;                ///< the object stands on its end at the goal
  bool only_parts = false;            ///< to hold it elsewhere than at the first of `parts` will not do
  Approach approach = Approach::any;  ///< of the hand
};

/// The present grasp of the hand.
struct Grasp {
  Pose X_WT;
  double opening_m = 0;  ///< of each finger before it closed
};

struct Handling {
  std::string object;
  Grip grip;
  std::optional<SetDown> set_down;
  std::string into;       ///< the container at the goal, or empty
  bool on_end = false;    ///< the object is stood on its end
  bool has_room = false;  ///< hand and object find room
  bool reached = false;   ///< the arm reaches the object and its goal
};

/// Knowledge for all handlings: the form of the avatar and of things.
struct Means {
  const AvatarForm& avatar;
  const ObjectShapes& shapes;
};

/// Grips at the task's object: the present grasp, or all possible ones.
std::vector<Grip> starts_of(const Task& task, const WorldSnapshot& world, const Means& means,
                            const std::optional<Grasp>& grasp);

/// Cost of a grip like one that has failed, in the unit of grip_choice.cpp: more than all costs of taste together, less
/// than the cost of a wrist at its limit.
inline constexpr double tried_cost = 5;

/// Two grips are so similar that both would fail.
bool alike(const Grip& a, const Grip& b);

/// The best handling in the present `world`. `grasp`: the hand's hold on the object, if any, which is kept. Grips like
/// those `tried` come last. Nothing if there is no way to hold the object.
std::optional<Handling> plan_handling(const Task& task, const WorldSnapshot& world, const Means& means,
                                      const std::optional<Grasp>& grasp, const std::vector<Grip>& tried);

/// A handling that makes room for the task: the smallest shift of another object with room for the hand. With the
/// task's object in the hand (`grasp`), that object is set down to be grasped anew. Nothing if no handling helps.
std::optional<Handling> make_room(const Task& task, const WorldSnapshot& world, const Means& means,
                                  const std::optional<Grasp>& grasp);

/// A handling that sets down the held object at a free place, below or nearby. Nothing if there is no such place.
std::optional<Handling> set_aside(const std::string& held, const WorldSnapshot& world, const Means& means,
                                  const Grasp& grasp);

}  // namespace continua
