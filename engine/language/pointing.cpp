#include "continua/language/pointing.h"

#include <algorithm>
#include <cmath>

namespace continua {
namespace {

constexpr double full_turn = 6.283185307179586;

// The offset of the place from the object's centre, and the variances of that offset.
struct Aim {
  double x, y;
  double variance_x, variance_y;
};

double variance(double extent_m) { return hand_sd_m * hand_sd_m + extent_m * extent_m / 36; }

Aim aim(const Vec3& pointed_W, const ObjectState& object) {
  const Box bounds = object.bounds_W();
  const Vec3 offset = on_grid(pointed_W) - bounds.center(), extent = bounds.max - bounds.min;
  return {offset.x(), offset.y(), variance(extent.x()), variance(extent.y())};
}

// The distance from the object's centre in standard deviations.
double deviations(const Aim& at) { return std::sqrt(at.x * at.x / at.variance_x + at.y * at.y / at.variance_y); }

// An upper bound a·d + b·d² for the change of the density's logarithm when the offset changes by d.
struct Steepness {
  double a, b;
  Steepness operator+(const Steepness& other) const { return {a + other.a, b + other.b}; }
};

Steepness steepness(const Aim& aim) {
  const double least = std::min(aim.variance_x, aim.variance_y);
  return {std::hypot(aim.x / aim.variance_x, aim.y / aim.variance_y), 1 / (2 * least)};
}

// The distance that place and objects may move before the logarithm changes by `gap`. If both move by m, an offset
// changes by up to 2m.
double movement(double gap, const Steepness& of) {
  return (std::sqrt(of.a * of.a + 4 * of.b * std::abs(gap)) - of.a) / (4 * of.b);
}

}  // namespace

double pointing_density(const Vec3& pointed_W, const ObjectState& object) {
  const Aim at = aim(pointed_W, object);
  const double square = deviations(at) * deviations(at);
  return std::exp(-square / 2) / (full_turn * std::sqrt(at.variance_x * at.variance_y)) + astray_per_m2;
}

bool is_pointed_at(const Vec3& pointed_W, const ObjectState& object) {
  return deviations(aim(pointed_W, object)) <= farthest_aim;
}

double pointing_margin(const Vec3& pointed_W, const ObjectState& a, const ObjectState& b, double ratio) {
  const double gap = std::log(pointing_density(pointed_W, a) / pointing_density(pointed_W, b) / ratio);
  return movement(gap, steepness(aim(pointed_W, a)) + steepness(aim(pointed_W, b)));
}

double pointing_margin(const Vec3& pointed_W, const ObjectState& object) {
  const Aim at = aim(pointed_W, object);
  // If place and object both move by m, the offset changes by up to 2m.
  return std::abs(deviations(at) - farthest_aim) * std::sqrt(std::min(at.variance_x, at.variance_y)) / 2;
}

}  // namespace continua
