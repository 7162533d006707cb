// The likelihood that pointing at a place on the table means an object, and the program by whose application a pointing
// becomes things and a place.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/term/evaluate.h"
#include "continua/world/world_snapshot.h"

namespace continua {

/// Standard deviation of a hand that points, along x and along y: 2.4 cm, the noise of EMRE's pointing (6 cm in a world
/// 2.5 times as large).
/// Knowledge with a VoxML document for [[point]] tells it instead (DeicticProgram).
inline constexpr double hand_sd_m = 0.024;

/// [[point]] (paper, figure of [[point]]), read from its VoxML document.
struct DeicticProgram {
  std::string name;  ///< point
  Term function;     ///< e -> e -> num -> loc -> e* • loc: of agent, finger, spread and place
  double least_sd_m = hand_sd_m, sd_per_metre_m = 0;

  /// Standard deviation of a pointing that extends so far, in metres. Without a distance it is the least.
  double sd_m(std::optional<double> distance_m) const;
};

/// Names without a rule, for the function of a DeicticProgram: met : loc -> num -> e*, the things that a vector with
/// this spread meets, a fact of the world; vec : e -> e -> loc -> loc, the vector from an agent through a finger onto a
/// place.
const Term& met_name();
const Term& vector_name();

/// A pointing as a value: dot([plate, knife], <0.1, 0.2, 0>), of type e* • loc.
Term pointing_term(const std::vector<std::string>& things, const Vec3& place_W);

/// The program applied to the human, this hand ("left", "right" or empty) and the place; the world met these things.
Application application_of(const DeicticProgram& program, const std::string& hand, double sd_m, const Vec3& place_W,
                           const std::vector<std::string>& things);

/// One pointing in 300 goes astray, anywhere within a square metre. Every object has at least this density everywhere.
inline constexpr double astray_per_m2 = 1.0 / 300;

/// An object is not meant if its density is less than this share of the highest one. A hand that means it nevertheless
/// would have to stray toward the likeliest object by 2.4 standard deviations or more.
inline constexpr double least_share = 0.05;

/// Likelihood of pointing there when the object is meant: a density over the table, 1/m². It is the sum of
/// `astray_per_m2` and a normal distribution around the centre of the object's footprint. The variance along each axis
/// is the hand's (`sd_m`, squared) plus the aim's; the standard deviation of the aim is a third of half the object's
/// extent.
double pointing_density(const Vec3& pointed_W, const ObjectState& object, double sd_m = hand_sd_m);

/// Beyond so many standard deviations from the object's centre, along either axis, a pointing means a place: of those
/// that mean the object one in ninety is farther (a normal distribution in two dimensions).
inline constexpr double farthest_aim = 3;

/// Whether the place is near the object, whatever other objects there are.
bool is_pointed_at(const Vec3& pointed_W, const ObjectState& object, double sd_m = hand_sd_m);

/// The distance in metres that the place and the objects may move before density(a) / density(b) reaches `ratio`.
double pointing_margin(const Vec3& pointed_W, const ObjectState& a, const ObjectState& b, double ratio,
                       double sd_m = hand_sd_m);
/// The same, before is_pointed_at() changes.
double pointing_margin(const Vec3& pointed_W, const ObjectState& object, double sd_m = hand_sd_m);

}  // namespace continua
