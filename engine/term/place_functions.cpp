// The rules of places. A point counts as a region without extent.
#include <algorithm>
#include <array>
#include <cmath>

#include "continua/term/rules.h"

namespace continua {
namespace {

using Arguments = std::span<const Term>;

Point center(const Place& place) {
  Point center;
  for (std::size_t i = 0; i < 3; ++i) center[i] = place.region ? (place.min[i] + place.max[i]) / 2 : place.min[i];
  return center;
}

Term point(const Point& p) { return Term::point(p[0], p[1], p[2]); }

double distance(const Point& a, const Point& b) {
  return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

auto coordinate(std::size_t axis) {
  return [axis](Arguments a, Evaluation&) { return Term::number(center(a[0].place_value())[axis]); };
}

Term extent(Arguments a, Evaluation&) {
  const auto& place = a[0].place_value();
  return Term::number(
      std::max({place.max[0] - place.min[0], place.max[1] - place.min[1], place.max[2] - place.min[2]}));
}

Term square(Arguments a, Evaluation&) {
  const Point c = center(a[0].place_value());
  const double half = std::abs(a[1].number_value()) / 2;
  return Term::place({{c[0] - half, c[1] - half, c[2]}, {c[0] + half, c[1] + half, c[2]}, true});
}

// In x and y; borders belong to the region. The margin is the movement of the nearest deciding side.
Term inside(Arguments a, Evaluation& evaluation) {
  const auto &inner = a[0].place_value(), &outer = a[1].place_value();
  const double slack = std::min({inner.min[0] - outer.min[0], outer.max[0] - inner.max[0], inner.min[1] - outer.min[1],
                                 outer.max[1] - inner.max[1]});
  evaluation.note_margin(std::abs(slack));
  return Term::truth(slack >= 0);
}

// The common region in x and y, at the height of the first.
Term overlap(Arguments a, Evaluation&) {
  const auto &one = a[0].place_value(), &other = a[1].place_value();
  Place common{one.min, one.max, true};
  for (std::size_t i = 0; i < 2; ++i) {
    common.min[i] = std::max(one.min[i], other.min[i]);
    common.max[i] = std::min(one.max[i], other.max[i]);
    if (common.max[i] < common.min[i]) return Term::null();
  }
  return Term::place(common);
}

// Grows on every side, in x and y.
Term grow(Arguments a, Evaluation&) {
  Place place = a[0].place_value();
  place.region = true;
  for (std::size_t i = 0; i < 2; ++i) {
    place.min[i] -= a[1].number_value();
    place.max[i] += a[1].number_value();
    if (place.max[i] < place.min[i]) return Term::null();
  }
  return Term::place(place);
}

Term toward(Arguments a, Evaluation&) {
  const Point from = center(a[0].place_value()), to = center(a[1].place_value());
  const double whole = distance(from, to), step = std::max(0.0, a[2].number_value());
  if (whole <= step) return point(to);
  Point moved;
  for (std::size_t i = 0; i < 3; ++i) moved[i] = from[i] + (to[i] - from[i]) * (step / whole);
  return point(moved);
}

// The smallest region that contains both.
Term box(Arguments a, Evaluation&) {
  const auto &one = a[0].place_value(), &other = a[1].place_value();
  Place place{{}, {}, true};
  for (std::size_t i = 0; i < 3; ++i) {
    place.min[i] = std::min(one.min[i], other.min[i]);
    place.max[i] = std::max(one.max[i], other.max[i]);
  }
  return Term::place(place);
}

}  // namespace

void add_place_functions(Rules& rules, Signature& signature) {
  const auto xyz = [](Arguments a, Evaluation&) {
    return Term::point(a[0].number_value(), a[1].number_value(), a[2].number_value());
  };
  const auto low = [](Arguments a, Evaluation&) { return point(a[0].place_value().min); };
  const auto high = [](Arguments a, Evaluation&) { return point(a[0].place_value().max); };
  const auto middle = [](Arguments a, Evaluation&) { return point(center(a[0].place_value())); };
  const auto between = [](Arguments a, Evaluation&) {
    return Term::number(distance(center(a[0].place_value()), center(a[1].place_value())));
  };
  add_functions(
      {
          {"xyz", "num -> num -> num -> loc", xyz},
          {"box", "loc -> loc -> loc", box},
          {"x", "loc -> num", coordinate(0)},
          {"y", "loc -> num", coordinate(1)},
          {"z", "loc -> num", coordinate(2)},
          {"center", "loc -> loc", middle},
          {"low_corner", "loc -> loc", low},
          {"high_corner", "loc -> loc", high},
          {"extent", "loc -> num", extent},
          {"square", "loc -> num -> loc", square},
          {"inside", "loc -> loc -> t", inside},
          {"overlap", "loc -> loc -> loc", overlap},
          {"grow", "loc -> num -> loc", grow},
          {"distance", "loc -> loc -> num", between},
          {"toward", "loc -> loc -> num -> loc", toward},
      },
      rules, signature);
}

}  // namespace continua
