// Spatial relations, computed from boxes parallel to W's axes on the position grid (world/geometry.h). What holds does
// so by a margin in metres: a length between the boxes that would have to change by as much for it to fail.
//
// Each holds of a thing A and a landmark L where
//
// - left, right, in_front, behind: on that side, A's centre is beyond L's by more than half of what parts them side by
//   side, across it their extents overlap, and neither rests on the other. (Roughly: it is at least as far beyond as
//   it is to the side of that. Loosely: beyond is enough.)
// - between: A is on the side of L that faces L2, and on L2's that faces L, along the line of their centres. (Loosely
//   as roughly: what is off the line is not between.)
// - on: A's bottom is at L's top (`touching_m`) and their extents overlap in x and y.
// - under: A's top is not above L's bottom (`touching_m`) and their extents overlap in x and y.
// - in: A's centre is over L's hollow, and A's bottom in it.
// - touching: no gap of `contact_m` parts them along any axis.
// - at: on, in or touching.
// - beside: seen from above they are apart (`touching_m`), and by less than `beside_m`. (Roughly: twice, loosely: three
//   times that; so with near.)
// - near: seen from above they are apart by less than `near_m`, or not at all.
//
// A participant is a landmark with sides of its own: in_front(avatar) is the half of the table at which the avatar
// sits, left(avatar) the half at its left hand. At, near and beside a participant is less than `near_m` from its edge
// of the table; no other relation to one holds. A point or region is a landmark too: at, in and on it is where A's
// centre is within it, or misses it by less than `contact_m`. Nothing stands in a relation to itself.
//
// Source of the sides: the referring expressions of EMRE; tests/emre/README.md, which also tells the sizes of its
// things.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "continua/world/perspective.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// Tolerance of measured contact: lengths below it are no gap and no overlap. 1.2 mm.
inline constexpr double touching_m = 1.2e-3;
/// What is called touching: no finger fits between. 1 cm.
inline constexpr double contact_m = 1e-2;
inline constexpr double beside_m = 0.05;
inline constexpr double near_m = 0.1;

enum class Relation { left, right, in_front, behind, on, in, at, near, beside, touching, under, between };

/// By its name, as place terms have it: "in_front".
std::optional<Relation> relation_named(std::string_view name);
std::string_view name_of(Relation relation);
/// 2 for `between`, else 1.
std::size_t landmarks_of(Relation relation);

/// "avatar" or "human": the two who talk, as landmarks.
std::optional<Perspective> participant_named(std::string_view name);

/// How sides are taken: as above, or where nothing would be said of anything in that sense.
enum class Sides { exact, rough, loose };

/// What something stands in a relation to.
struct Landmark {
  /// REQUIRES that the object outlives it
  static Landmark object(const ObjectState& object);
  static Landmark participant(Perspective who, const Box& table);
  static Landmark place(const Box& region_W);
  /// An object of the world, else a participant; none if it is neither.
  static std::optional<Landmark> named(std::string_view name, const WorldSnapshot& world);

  Box bounds_W;                         ///< of a participant, its edge of the table
  const ObjectState* thing = nullptr;   ///< of an object
  std::optional<Perspective> who = {};  ///< of a participant
};

/// left, right, in_front or behind
bool is_side(Relation relation);
/// Of left right, of in_front behind, and the reverse. REQUIRES is_side(side)
Relation opposite(Relation side);
/// Unit vector toward the side that a perspective calls left, right, in front or behind. What is in front of something
/// is nearer to whose perspective it is. REQUIRES is_side(side)
Vec3 side_W(Relation side, Perspective perspective);

/// By how many metres the relation holds; it does where this is above 0, and fails by as much below. It is -infinity
/// where no length would make it hold. `landmarks` are as many as landmarks_of(relation) says; otherwise it fails.
double holds_by(Relation relation, const ObjectState& object, std::span<const Landmark> landmarks, const Box& table,
                Perspective perspective, Sides sides = Sides::exact);

}  // namespace continua
