// Which object a place on the table that someone points at can mean.
#pragma once

#include "continua/world/world_snapshot.h"

namespace continua {

/// Standard deviation of a hand that points, along x and along y: 2.4 cm, the noise of EMRE's pointing (6 cm in a world
/// 2.5 times as large).
inline constexpr double hand_sd_m = 0.024;

/// One pointing in 300 goes astray, to anywhere within a square metre: the density that every object has everywhere.
inline constexpr double astray_per_m2 = 1.0 / 300;

/// An object less than this share as likely as the likeliest is not meant. Were a hand as above to mean it
/// nevertheless, it would have strayed toward the other by 3.7 standard deviations or more.
inline constexpr double least_share = 1e-3;

/// Likelihood of pointing there when the object is meant: a density over the table, 1/m². The normal distribution
/// around the centre of its footprint, whose variance along each axis is that of the hand and of where on the object
/// one aims (a third of half its extent), and `astray_per_m2`.
double pointing_density(const Vec3& pointed_W, const ObjectState& object);

/// Whether the object, alone on the table, would count as pointed at: likelier to be meant than a stray.
bool is_pointed_at(const Vec3& pointed_W, const ObjectState& object);

/// How far the place and the objects may move, metres, before density(a) / density(b) grows or shrinks to `ratio`, and
/// before is_pointed_at changes.
double pointing_margin(const Vec3& pointed_W, const ObjectState& a, const ObjectState& b, double ratio);
double pointing_margin(const Vec3& pointed_W, const ObjectState& object);

}  // namespace continua
