// The acts of a body and the programs that name them. A new act begins with a line in each of the three lists below;
// the properties in its row decide what both bodies and the facts about programs make of it.
#pragma once

#include <array>
#include <cstddef>
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

/// The changes that an act makes, from nothing to the place of an object.
enum class ActEffect {
  announced,  ///< nothing: only the log shows the act, on a body without a head
  shown,      ///< the hand shows something and moves nothing
  hand,       ///< hand and fingers alone: no object is named
  held,       ///< an object comes to be held
  moved,      ///< an object comes to another place or attitude
};

/// How an act's object comes to a goal.
enum class ToGoal { none, carried, pushed };

/// Whether the hand lets go in the end.
enum class HandAfter {
  kept,       ///< the hand lets go of nothing
  as_before,  ///< the object if it was held before the act, else nothing
  empty,
};

struct ActRow {
  Capability what;
  std::string_view name;
  ActEffect effect;
  ToGoal to_goal = ToGoal::none;
  HandAfter hand_after = HandAfter::kept;
};

/// In the order of the enumeration.
inline constexpr std::array body_acts = {
    ActRow{Capability::reach, "reach", ActEffect::shown},
    ActRow{Capability::point, "point", ActEffect::shown},
    ActRow{Capability::look, "look", ActEffect::announced},
    ActRow{Capability::grasp, "grasp", ActEffect::held},
    ActRow{Capability::lift, "lift", ActEffect::moved},
    ActRow{Capability::put, "put", ActEffect::moved, ToGoal::carried, HandAfter::empty},
    ActRow{Capability::slide, "slide", ActEffect::moved, ToGoal::carried, HandAfter::as_before},
    ActRow{Capability::move, "move", ActEffect::moved, ToGoal::carried},
    ActRow{Capability::push, "push", ActEffect::moved, ToGoal::pushed, HandAfter::empty},
    ActRow{Capability::turn, "turn", ActEffect::moved, ToGoal::none, HandAfter::as_before},
    ActRow{Capability::ungrasp, "ungrasp", ActEffect::hand},
    ActRow{Capability::retract, "retract", ActEffect::hand},
    ActRow{Capability::stop, "stop", ActEffect::hand},
    ActRow{Capability::signal, "signal", ActEffect::announced},
};

/// The arguments of a program: a thing, a place, or either; an angle is in degrees. A grip is the part of the thing and
/// the side from which the hand comes, texts, either of which may be empty.
enum class Takes {
  nothing,
  thing,
  thing_and_angle,
  thing_and_grip,
  thing_and_goal,
  thing_or_place,
  last_is_thing_or_place
};

/// A program that the body performs itself, by the name that terms and voxemes use.
struct BodyProgram {
  std::string_view name;
  Capability what;
  Takes takes;
};

inline constexpr std::array body_programs = {
    BodyProgram{"grasp", Capability::grasp, Takes::thing},
    BodyProgram{"hold", Capability::grasp, Takes::thing},
    BodyProgram{"grip", Capability::grasp, Takes::thing_and_grip},
    BodyProgram{"lift", Capability::lift, Takes::thing},
    BodyProgram{"ungrasp", Capability::ungrasp, Takes::thing},
    BodyProgram{"put", Capability::put, Takes::thing_and_goal},
    BodyProgram{"move", Capability::move, Takes::thing_and_goal},
    BodyProgram{"slide", Capability::slide, Takes::thing_and_goal},
    BodyProgram{"push", Capability::push, Takes::thing_and_goal},
    BodyProgram{"turn", Capability::turn, Takes::thing},
    BodyProgram{"turn_by", Capability::turn, Takes::thing_and_angle},
    BodyProgram{"retract", Capability::retract, Takes::nothing},
    BodyProgram{"stop", Capability::stop, Takes::nothing},
    BodyProgram{"reach", Capability::reach, Takes::thing_or_place},
    BodyProgram{"look_at", Capability::look, Takes::thing_or_place},
    BodyProgram{"point", Capability::point, Takes::last_is_thing_or_place},
};

constexpr const ActRow& row_of(Capability what) { return body_acts[static_cast<std::size_t>(what)]; }

/// `put`, `grasp` …
inline std::string name_of(Capability what) { return std::string(row_of(what).name); }
constexpr ActEffect effect_of(Capability what) { return row_of(what).effect; }
constexpr ToGoal to_goal(Capability what) { return row_of(what).to_goal; }

/// The act brings its object to a goal.
constexpr bool moves_to_goal(Capability what) { return to_goal(what) != ToGoal::none; }
/// The act does so with the object in the hand.
constexpr bool is_carried(Capability what) { return to_goal(what) == ToGoal::carried; }
/// The act only shows something; nothing is moved.
constexpr bool is_gesture(Capability what) { return effect_of(what) == ActEffect::shown; }
/// The act is about one object, which it takes hold of or moves.
constexpr bool needs_object(Capability what) { return effect_of(what) >= ActEffect::held; }

/// The hand is empty after the act; `in_hand`: the hand held the object before.
constexpr bool empties_hand(Capability what, bool in_hand) {
  const HandAfter after = row_of(what).hand_after;
  return after == HandAfter::empty || (after == HandAfter::as_before && !in_hand);
}

/// The body's own program of that name, or nullptr.
const BodyProgram* body_program(std::string_view name);

/// The most arguments that the program takes.
std::size_t most_arguments(const BodyProgram& program);

}  // namespace continua
