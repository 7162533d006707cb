// The acts that a body can do, and the programs that name them. Every act that the avatar performs is composed of
// these. Both tables stand in capability.cpp: a new act of the body begins with a row there.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace continua {

enum class Capability {
  reach,  ///< hand goes over an object or place, without touching
  point,  ///< hand stretches toward an object or place
  look,   ///< gaze turns to an object or place
  grasp,  ///< fingers close on the object, which stays where it is
  lift,   ///< grasped object rises by `height_m` and stays held
  put,    ///< object is grasped if it is not, carried to the goal, set down and released
  slide,  ///< like move, but along the table; an object that is not held is grasped first and released in the end
  move,   ///< grasped object is carried to the goal and set down there; the fingers stay closed
  push,   ///< hand comes down behind the object and moves it along the table by contact; nothing is grasped
  turn,   ///< object turns about the vertical by `turn_rad`; if it is not held, it is grasped first and set down again
  ungrasp,  ///< held object is lowered onto what is below it, the fingers open, the hand backs off
  retract,  ///< hand goes back to where it was at the start and keeps what it holds
  stop,    ///< the act under way ends where it is, waiting acts are given up; a held object stays held, even in mid-air
  signal,  ///< a named gesture (nod, thumbs up)
};

/// What an act changes, from nothing to the place of an object.
enum class ActEffect {
  announced,  ///< nothing: only the log shows the act, on a body without a head
  shown,      ///< the hand shows something and moves nothing
  hand,       ///< hand and fingers alone: no object is named
  held,       ///< an object comes to be held
  moved,      ///< an object comes to another place or attitude
};

/// How an act's object comes to a goal.
enum class ToGoal { none, carried, pushed };

/// `put`, `grasp` …
std::string name_of(Capability what);
ActEffect effect_of(Capability what);
ToGoal to_goal(Capability what);

/// The act brings its object to a goal.
inline bool moves_to_goal(Capability what) { return to_goal(what) != ToGoal::none; }
/// The act only shows something; nothing is moved.
inline bool is_gesture(Capability what) { return effect_of(what) == ActEffect::shown; }
/// The act is about one object, which it takes hold of or moves.
inline bool needs_object(Capability what) { return effect_of(what) >= ActEffect::held; }

/// The arguments of a program: a thing, a place, or either; an angle is in degrees.
enum class Takes { nothing, thing, thing_and_angle, thing_and_goal, thing_or_place, last_is_thing_or_place };

/// A program that the body performs itself, by the name that terms and voxemes use.
struct BodyProgram {
  std::string_view name;
  Capability what;
  Takes takes;
};

/// The body's own program of that name, or nullptr.
const BodyProgram* body_program(std::string_view name);

/// The most arguments that the program takes.
std::size_t most_arguments(const BodyProgram& program);

}  // namespace continua
