#include "continua/world/relations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "continua/core/result.h"

namespace continua {
namespace {

constexpr double never = -std::numeric_limits<double>::infinity();

constexpr std::array<std::string_view, 12> names = {"left", "right", "in_front", "behind",   "on",    "in",
                                                    "at",   "near",  "beside",   "touching", "under", "between"};

// The gap between two boxes seen from above; 0 where they overlap.
double gap_above(const Box& a, const Box& b) {
  const Vec3 depth = depth_of(a, b);
  return std::hypot(std::min(depth.x(), 0.0), std::min(depth.y(), 0.0));
}

// Half of a box's extent along a horizontal direction.
double half_along(const Box& box, const Vec3& direction_W) {
  return ((box.max - box.min) / 2).dot(direction_W.cwiseAbs());
}

double rests_by(const Box& upper, const Box& lower) {
  const Vec3 depth = depth_of(upper, lower);
  return std::min({touching_m - std::abs(upper.min.z() - lower.max.z()), depth.x(), depth.y()});
}

double below_by(const Box& a, const Box& b) {
  const Vec3 depth = depth_of(a, b);
  return std::min({b.min.z() - a.max.z() + touching_m, depth.x(), depth.y()});
}

// `side` is a horizontal unit vector.
double toward_by(const Box& a, const Box& b, const Vec3& side, Sides sides) {
  const Vec3 between = a.center() - b.center(), across(-side.y(), side.x(), 0);
  const double beyond = between.dot(side) - (half_along(a, side) + half_along(b, side)) / 2;
  const double aside = std::abs(between.dot(across));
  double by = beyond;
  if (sides == Sides::exact) by = std::min(by, half_along(a, across) + half_along(b, across) - aside);
  if (sides == Sides::rough) by = std::min(by, (between.dot(side) - aside) / std::sqrt(2) + position_grid_m);
  return std::min({by, -rests_by(a, b), -rests_by(b, a)});
}

// Factor by which `near` and `beside` reach farther.
double reach(Sides sides) { return 1 + static_cast<double>(sides); }

double between_by(const Box& a, const Box& first, const Box& second, Sides sides) {
  Vec3 line = second.center() - first.center();
  line.z() = 0;
  if (line.norm() < position_grid_m) return never;
  line.normalize();
  if (sides == Sides::loose) sides = Sides::rough;
  return std::min(toward_by(a, first, line, sides), toward_by(a, second, -line, sides));
}

double inside_by(const Box& a, const ObjectState* container) {
  const auto hollow = container ? container->interior_W() : std::nullopt;
  if (!hollow) return never;
  const Vec3 center = a.center();
  return std::min({center.x() - hollow->min.x(), hollow->max.x() - center.x(), center.y() - hollow->min.y(),
                   hollow->max.y() - center.y(), hollow->max.z() - a.min.z(),
                   a.min.z() - hollow->min.z() + touching_m});
}

double within_by(const Vec3& center, const Box& region) {
  const Vec3 inner = (center - region.min).cwiseMin(region.max - center);
  return std::min(inner.x(), inner.y()) + contact_m;
}

double holds_of_box(Relation relation, const Box& a, const Landmark& landmark, Perspective perspective, Sides sides) {
  const Box& b = landmark.bounds_W;
  const bool place = !landmark.thing;
  switch (relation) {
    case Relation::left:
    case Relation::right:
    case Relation::in_front:
    case Relation::behind:
      return toward_by(a, b, side_W(relation, perspective), sides);
    case Relation::on:
      return place ? within_by(a.center(), b) : rests_by(a, b);
    case Relation::in:
      return place ? within_by(a.center(), b) : inside_by(a, landmark.thing);
    case Relation::at:
      if (place) return within_by(a.center(), b);
      return std::max({rests_by(a, b), inside_by(a, landmark.thing), depth_of(a, b).minCoeff() + contact_m});
    case Relation::touching:
      return depth_of(a, b).minCoeff() + contact_m;
    case Relation::near:
      return near_m * reach(sides) - gap_above(a, b);
    case Relation::beside:
      return std::min(beside_m * reach(sides) - gap_above(a, b),
                      touching_m - std::min(depth_of(a, b).x(), depth_of(a, b).y()));
    case Relation::under:
      return below_by(a, b);
    case Relation::between:
      break;
  }
  return never;
}

double holds_of_participant(Relation relation, const Box& a, const Landmark& landmark, const Box& table) {
  switch (relation) {
    case Relation::left:
    case Relation::right:
    case Relation::in_front:  // things on a participant's side of the table are in front of that participant
      return (a.center() - table.center()).dot(side_W(relation, *landmark.who));
    case Relation::at:
    case Relation::near:
    case Relation::beside:
      return near_participant_m - gap_above(a, landmark.bounds_W);
    default:
      return never;
  }
}

}  // namespace

std::optional<Relation> relation_named(std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Relation>(found - names.begin());
}

std::string_view name_of(Relation relation) { return names[static_cast<std::size_t>(relation)]; }

std::size_t landmarks_of(Relation relation) { return relation == Relation::between ? 2 : 1; }

std::optional<Perspective> participant_named(std::string_view name) {
  if (name == "avatar") return Perspective::avatar;
  if (name == "human") return Perspective::human;
  return std::nullopt;
}

Landmark Landmark::object(const ObjectState& object) { return {object.bounds_W(), &object, {}}; }

Landmark Landmark::participant(Perspective who, const Box& table) {
  Box edge = table;
  (who == Perspective::avatar ? edge.min : edge.max).y() = (who == Perspective::avatar ? table.max : table.min).y();
  return {edge, nullptr, who};
}

Landmark Landmark::place(const Box& region_W) { return {region_W, nullptr, {}}; }

std::optional<Landmark> Landmark::named(std::string_view name, const WorldSnapshot& world) {
  if (const auto* found = world.find(name)) return object(*found);
  if (const auto who = participant_named(name)) return participant(*who, world.table);
  return std::nullopt;
}

bool is_side(Relation relation) { return relation <= Relation::behind; }

Relation opposite(Relation side) {
  require(is_side(side), "only sides have an opposite");
  constexpr std::array opposites = {Relation::right, Relation::left, Relation::behind, Relation::in_front};
  return opposites[static_cast<std::size_t>(side)];
}

Vec3 side_W(Relation side, Perspective perspective) {
  const double human = perspective == Perspective::human ? 1 : -1;
  switch (side) {
    case Relation::left:
      return {-human, 0, 0};
    case Relation::right:
      return {human, 0, 0};
    case Relation::in_front:
      return {0, -human, 0};
    case Relation::behind:
      return {0, human, 0};
    default:
      break;
  }
  require(false, "only sides have a direction");
  return Vec3::Zero();
}

double holds_by(Relation relation, const ObjectState& object, std::span<const Landmark> landmarks, const Box& table,
                Perspective perspective, Sides sides) {
  if (landmarks.size() != landmarks_of(relation)) return never;
  for (const auto& each : landmarks)
    if (each.thing && each.thing->name == object.name) return never;
  const Box bounds = object.bounds_W();
  double by = never;
  if (relation == Relation::between)
    by = between_by(bounds, landmarks[0].bounds_W, landmarks[1].bounds_W, sides);
  else if (landmarks[0].who)
    by = holds_of_participant(relation, bounds, landmarks[0], table);
  else
    by = holds_of_box(relation, bounds, landmarks[0], perspective, sides);
  return std::isfinite(by) ? on_grid(by) : by;
}

}  // namespace continua
