// Spatial relations between boxes parallel to W's axes, on the position grid (world/geometry.h). A relation holds by a
// margin in metres: some length between the boxes would have to change by as much for the relation to fail.
//
// A thing A stands in a relation to a landmark L under these conditions:
//
// - left, right, in_front, behind: toward that side, A's centre is beyond L's by more than half of the distance of
//   centres side by side; across that direction their extents overlap; neither rests on the other. (Roughly: A is at
//   least as far beyond as aside. Loosely: beyond is enough.)
// - between: A is on the side of L that faces L2, and on the side of L2 that faces L, along the line of their centres.
//   (Loosely is the same as roughly: a thing off the line is not between.)
// - on: A's bottom is at L's top (`touching_m`) and their extents overlap in x and y.
// - under: A's top is not above L's bottom (`touching_m`) and their extents overlap in x and y.
// - in: A's centre is over L's hollow, and A's bottom in it.
// - touching: no gap of `contact_m` parts them along any axis.
// - at: on, in or touching.
// - beside: seen from above they are apart (`touching_m`), and by less than `beside_m`. (Roughly: twice that distance,
//   loosely: three times. The same goes for near.)
// - near: seen from above the gap between them is less than `near_m`, or there is none.
//
// A participant is a landmark with sides of its own: in_front(avatar) is the half of the table at which the avatar
// sits, left(avatar) the half at the avatar's left hand. At, near and beside a participant is a place less than
// `near_participant_m` from that participant's edge of the table; all other relations to participants fail. A point or
// region is a landmark too: A is at, in and on it if A's centre is within it, or misses it by less than `contact_m`. No
// thing stands in a relation to itself.
//
// Source of the sides: the referring expressions of EMRE (tests/emre/README.md, with the sizes of its things).
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "continua/world/perspective.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// Tolerance of measured contact: a smaller length is neither gap nor overlap. 1.2 mm.
inline constexpr double touching_m = 1.2e-3;
/// Things at a smaller distance are called touching: no finger fits between. 1 cm.
inline constexpr double contact_m = 1e-2;
inline constexpr double beside_m = 0.05;
inline constexpr double near_m = 0.1;
/// A person at the edge of the table reaches that far over it.
inline constexpr double near_participant_m = 0.25;

enum class Relation { left, right, in_front, behind, on, in, at, near, beside, touching, under, between };

/// The relation of that name in place terms: "in_front".
std::optional<Relation> relation_named(std::string_view name);
std::string_view name_of(Relation relation);
/// 2 for `between`, else 1.
std::size_t landmarks_of(Relation relation);

/// "avatar" or "human": a participant of the conversation, as a landmark.
std::optional<Perspective> participant_named(std::string_view name);

/// How strictly sides are taken: as above, or less so for words that would otherwise fit no thing.
enum class Sides { exact, rough, loose };

/// The second party of a relation.
struct Landmark {
  /// REQUIRES that the object outlives it
  static Landmark object(const ObjectState& object);
  static Landmark participant(Perspective who, const Box& table);
  static Landmark place(const Box& region_W);
  /// The object or participant of that name; nothing if there is neither.
  static std::optional<Landmark> named(std::string_view name, const WorldSnapshot& world);

  Box bounds_W;                         ///< a participant's are those of the edge of the table
  const ObjectState* thing = nullptr;   ///< if the landmark is an object
  std::optional<Perspective> who = {};  ///< if the landmark is a participant
};

/// left, right, in_front or behind
bool is_side(Relation relation);
/// right for left, behind for in_front, and the reverse. REQUIRES is_side(side)
Relation opposite(Relation side);
/// Unit vector toward left, right, front or back in a perspective. The front of a thing faces the participant with that
/// perspective. REQUIRES is_side(side)
Vec3 side_W(Relation side, Perspective perspective);

/// The margin of the relation in metres: above 0 the relation holds, below 0 it fails by that much; -infinity if no
/// change of a length would make it hold, or if the number of `landmarks` is not landmarks_of(relation).
double holds_by(Relation relation, const ObjectState& object, std::span<const Landmark> landmarks, const Box& table,
                Perspective perspective, Sides sides = Sides::exact);

}  // namespace continua
