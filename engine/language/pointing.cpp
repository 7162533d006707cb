#include "continua/language/pointing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "continua/term/rules.h"
#include "continua/term/substitution.h"

namespace continua {
namespace {

constexpr double full_turn = 6.283185307179586;

// The offset of the place from the object's centre, and the variances of that offset.
struct Aim {
  double x, y;
  double variance_x, variance_y;
};

double variance(double extent_m, double sd_m) { return sd_m * sd_m + extent_m * extent_m / 36; }

Aim aim(const Vec3& pointed_W, const ObjectState& object, double sd_m) {
  const Box bounds = object.bounds_W();
  const Vec3 offset = on_grid(pointed_W) - bounds.center(), extent = bounds.max - bounds.min;
  return {offset.x(), offset.y(), variance(extent.x(), sd_m), variance(extent.y(), sd_m)};
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

double DeicticProgram::sd_m(std::optional<double> distance_m) const {
  return std::max(least_sd_m, distance_m.value_or(0) * sd_per_metre_m);
}

const Term& met_name() {
  static const Term met = Term::constant("met", Type::parse("loc -> num -> e*").value());
  return met;
}

const Term& vector_name() {
  static const Term vec = Term::constant("vec", Type::parse("e -> e -> loc -> loc").value());
  return vec;
}

Term pointing_term(const std::vector<std::string>& things, const Vec3& place_W) {
  std::vector<Term> objects;
  for (const auto& each : things) objects.push_back(Term::entity(each));
  Term pointing = Term::apply(pointing_constructor(), Term::list(std::move(objects), Type::entity()));
  return Term::apply(std::move(pointing), Term::point(place_W.x(), place_W.y(), place_W.z()));
}

Application application_of(const DeicticProgram& program, const std::string& hand, double sd_m, const Vec3& place_W,
                           const std::vector<std::string>& things) {
  Term of_place = program.function;
  for (const auto& given : {Term::entity("human"), Term::entity(hand.empty() ? "finger" : hand + "_finger"),
                            Term::number(std::round(sd_m * 1e6) / 1e6)})
    of_place = instantiate(of_place.body(), given);
  return {of_place, Term::point(place_W.x(), place_W.y(), place_W.z()), pointing_term(things, place_W), ""};
}

double pointing_density(const Vec3& pointed_W, const ObjectState& object, double sd_m) {
  const Aim at = aim(pointed_W, object, sd_m);
  const double square = deviations(at) * deviations(at);
  return std::exp(-square / 2) / (full_turn * std::sqrt(at.variance_x * at.variance_y)) + astray_per_m2;
}

bool is_pointed_at(const Vec3& pointed_W, const ObjectState& object, double sd_m) {
  return deviations(aim(pointed_W, object, sd_m)) <= farthest_aim;
}

double pointing_margin(const Vec3& pointed_W, const ObjectState& a, const ObjectState& b, double ratio, double sd_m) {
  const double gap = std::log(pointing_density(pointed_W, a, sd_m) / pointing_density(pointed_W, b, sd_m) / ratio);
  return movement(gap, steepness(aim(pointed_W, a, sd_m)) + steepness(aim(pointed_W, b, sd_m)));
}

double pointing_margin(const Vec3& pointed_W, const ObjectState& object, double sd_m) {
  const Aim at = aim(pointed_W, object, sd_m);
  // If place and object both move by m, the offset changes by up to 2m.
  return std::abs(deviations(at) - farthest_aim) * std::sqrt(std::min(at.variance_x, at.variance_y)) / 2;
}

}  // namespace continua
