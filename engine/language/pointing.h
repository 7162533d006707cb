// The likelihood that pointing at a place on the table means an object.
#pragma once

#include "continua/world/world_snapshot.h"

namespace continua {

/// Standard deviation of a hand that points, along x and along y: 2.4 cm, the noise of EMRE's pointing (6 cm in a world
/// 2.5 times as large).
inline constexpr double hand_sd_m = 0.024;

/// One pointing in 300 goes astray, anywhere within a square metre. Every object has at least this density everywhere.
inline constexpr double astray_per_m2 = 1.0 / 300;

/// An object is not meant if its density is less than this share of the highest one. A hand that means it nevertheless
/// would have to stray toward the likeliest object by 2.4 standard deviations or more.
inline constexpr double least_share = 0.05;

/// Likelihood of pointing there when the object is meant: a density over the table, 1/m². It is the sum of
/// `astray_per_m2` and a normal distribution around the centre of the object's footprint. The variance along each axis
/// is the hand's plus the aim's; the standard deviation of the aim is a third of half the object's extent.
double pointing_density(const Vec3& pointed_W, const ObjectState& object);

/// Beyond so many standard deviations from the object's centre, along either axis, a pointing means a place: of those
/// that mean the object one in ninety is farther (a normal distribution in two dimensions).
inline constexpr double farthest_aim = 3;

/// Whether the place is near the object, whatever other objects there are.
bool is_pointed_at(const Vec3& pointed_W, const ObjectState& object);

/// The distance in metres that the place and the objects may move before density(a) / density(b) reaches `ratio`.
double pointing_margin(const Vec3& pointed_W, const ObjectState& a, const ObjectState& b, double ratio);
/// The same, before is_pointed_at() changes.
double pointing_margin(const Vec3& pointed_W, const ObjectState& object);

}  // namespace continua
