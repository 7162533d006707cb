#include "continua/facts/formations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "continua/core/located_json.h"
#include "continua/term/rules.h"
#include "continua/world/geometry.h"
#include "continua/world/relations.h"
#include "continua/world/world_snapshot.h"

namespace continua {
namespace {

// The room that fingers need between two things of a ring, and the grid on which its middle is searched.
constexpr double finger_room_m = 0.03, middle_grid_m = 0.02;
constexpr int ring_turns = 36;  // the turns of a ring that are tried, evenly over the circle

Type type_of(std::string_view text) { return Type::parse(text).value(); }

Signature names_of_goals(const Signature& facts) {
  Signature names = term_signature();
  names.insert(facts.begin(), facts.end());
  names.emplace("at", type_of("e -> loc -> t"));  // of a goal; no place term of that name
  for (int each = 0; each <= static_cast<int>(Relation::between); ++each) {
    const auto relation = static_cast<Relation>(each);
    names.emplace(name_of(relation), type_of(landmarks_of(relation) == 2 ? "e -> e -> loc" : "e -> loc"));
  }
  return names;
}

// Half of the diagonal of what the thing takes up, seen from above.
double radius(const Box& bounds) {
  const Vec3 size = bounds.max - bounds.min;
  return std::hypot(size.x(), size.y()) / 2;
}

using Things = std::vector<const ObjectState*>;

double widest(const Things& things) {
  double widest = 0;
  for (const auto* thing : things) widest = std::max(widest, radius(thing->bounds_W()));
  return widest;
}

// Neighbours on a circle of n points are 2 R sin(pi / n) apart.
double ring_radius(const Things& things, double inner_m) {
  const double wide = widest(things), count = static_cast<double>(things.size());
  const double apart = things.size() < 2 ? 0 : (2 * wide + finger_room_m) / (2 * std::sin(std::numbers::pi / count));
  return std::max(apart, inner_m > 0 ? inner_m + finger_room_m + wide : 0);
}

std::vector<Vec3> ring(const Vec3& middle_W, double radius_m, std::size_t count, double turn = 0) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = turn + 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
    points.push_back(on_grid(middle_W + radius_m * Vec3(std::cos(angle), std::sin(angle), 0)));
  }
  return points;
}

bool overlaps(const Vec3& point, double wide, const Box& other) {
  return point.x() + wide > other.min.x() && point.x() - wide < other.max.x() && point.y() + wide > other.min.y() &&
         point.y() - wide < other.max.y();
}

bool lies_within(const Vec3& point, double wide, const Box& region) {
  return point.x() - wide >= region.min.x() && point.x() + wide <= region.max.x() &&
         point.y() - wide >= region.min.y() && point.y() + wide <= region.max.y();
}

// Whether a thing of that radius fits at the point: within the region, and where nothing stands.
bool is_free(const Vec3& point, double wide, const Box& region, const WorldSnapshot& world) {
  return lies_within(point, wide, region) &&
         std::none_of(world.objects.begin(), world.objects.end(),
                      [&](const ObjectState& other) { return overlaps(point, wide, other.bounds_W()); });
}

// The ring around the middle, turned so that most of its points are free.
std::vector<Vec3> turned_ring(const Vec3& middle_W, double radius_m, const Things& things, const WorldSnapshot& world) {
  std::vector<Vec3> best;
  std::ptrdiff_t most = -1;
  for (int i = 0; i < ring_turns; ++i) {
    auto points = ring(middle_W, radius_m, things.size(), 2 * std::numbers::pi * i / ring_turns);
    const auto free = std::count_if(points.begin(), points.end(), [&](const Vec3& point) {
      return is_free(point, widest(things), world.table, world);
    });
    if (free <= most) continue;
    best = std::move(points);
    most = free;
  }
  return best;
}

// Around the place, so far out that the things do not meet what takes up the place.
std::vector<Vec3> ring_around(const Box& place_W, const Things& things, const WorldSnapshot& world) {
  const Vec3 half = (place_W.max - place_W.min) / 2;
  Vec3 middle = place_W.center();
  middle.z() = world.table.max.z();
  return turned_ring(middle, ring_radius(things, std::max(half.x(), half.y())), things, world);
}

// Around the free spot of the region that is nearest to the middle of the things; around the region's centre where it
// has no such spot.
std::vector<Vec3> ring_within(const Box& region_W, const Things& things, const WorldSnapshot& world,
                              Evaluation& evaluation) {
  const double wide = widest(things), radius_m = ring_radius(things, 0);
  Vec3 middle = Vec3::Zero();
  for (const auto* thing : things) middle += thing->p_WO / static_cast<double>(things.size());
  std::optional<std::vector<Vec3>> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (double x = region_W.min.x(); x <= region_W.max.x(); x += middle_grid_m)
    for (double y = region_W.min.y(); y <= region_W.max.y(); y += middle_grid_m) {
      const double distance = std::hypot(x - middle.x(), y - middle.y());
      if (distance >= nearest || !evaluation.spend(1)) continue;
      auto points = ring(Vec3(x, y, region_W.max.z()), radius_m, things.size());
      const auto free = [&](const Vec3& point) { return is_free(point, wide, region_W, world); };
      if (!std::all_of(points.begin(), points.end(), free)) continue;
      best = std::move(points);
      nearest = distance;
    }
  return best ? *std::move(best) : turned_ring(region_W.center(), radius_m, things, world);
}

Box box_of(const Term& place) {
  const auto& [min, max, region] = place.place_value();
  return {{min[0], min[1], min[2]}, {max[0], max[1], max[2]}};
}

// A list of points for the things, from their places in the world; null if one of them is not in the world.
Term points_for(const Term& place, const Term& things, Evaluation& evaluation, auto ring) {
  const auto* world = evaluation.facts().world;
  Things found;
  for (const auto& each : things.elements()) {
    const bool is_name = each.kind() == Term::Kind::constant;
    found.push_back(world && is_name ? world->find(each.name()) : nullptr);
    if (!found.back()) return Term::null();
  }
  std::vector<Term> points;
  for (const auto& p_W : ring(box_of(place), found)) points.push_back(Term::point(p_W.x(), p_W.y(), p_W.z()));
  return Term::list(std::move(points), Type::location());
}

}  // namespace

Formations::Formations(const Catalogue& catalogue, const Signature& facts) {
  const auto names = names_of_goals(facts);
  for (const auto& [key, voxeme] : catalogue.voxemes()) {
    if (voxeme.goal.empty()) continue;
    const bool has_place = voxeme.arguments.size() > 2;
    auto goal = parse_term(voxeme.goal, names, type_of(has_place ? "e* -> loc -> t*" : "e* -> t*"));
    if (goal)
      goals_.emplace(voxeme.predicate, *std::move(goal));
    else
      problems_.push_back({voxeme.path, fmt::format("the goal {}: {}", in_quotes(voxeme.goal), goal.error().text())});
  }
}

Term Formations::steps(const std::string& program, std::span<const Term> arguments, Evaluation& evaluation) const {
  const auto found = goals_.find(program);
  if (found == goals_.end()) return Term::null();
  Term goal = found->second;
  for (const auto& argument : arguments) goal = evaluation.apply(goal, argument);
  if (goal.kind() != Term::Kind::list) return Term::null();
  const Term put = Term::constant("put", type_of("e -> loc -> t"));
  std::vector<Term> steps;
  for (const auto& state : goal.elements()) {
    const auto [head, parts] = state.spine();
    if (parts.size() != 2 || parts[0].is_null() || parts[1].is_null()) return Term::null();
    steps.push_back(evaluation.apply(evaluation.apply(put, parts[0]), parts[1]));
  }
  return Term::list(std::move(steps), Type::truth());
}

void add_formation_facts(const Catalogue* voxemes, Rules& rules, Signature& signature) {
  const auto around = [](std::span<const Term> a, Evaluation& evaluation) {
    return points_for(a[0], a[1], evaluation, [&](const Box& place, const Things& things) {
      return ring_around(place, things, *evaluation.facts().world);
    });
  };
  const auto within = [](std::span<const Term> a, Evaluation& evaluation) {
    return points_for(a[0], a[1], evaluation, [&](const Box& region, const Things& things) {
      return ring_within(region, things, *evaluation.facts().world, evaluation);
    });
  };
  add_functions({{"ring_around", "loc -> e* -> loc*", around}, {"ring_within", "loc -> e* -> loc*", within}}, rules,
                signature);
  const auto formations =
      voxemes ? std::make_shared<const Formations>(*voxemes, signature) : std::shared_ptr<const Formations>();
  const auto formed = [formations](std::span<const Term> a, Evaluation& evaluation) {
    return formations ? formations->steps(a[0].text_value(), a.subspan(1), evaluation) : Term::null();
  };
  add_functions({{"formed", "text -> e* -> t*", formed}, {"formed_at", "text -> e* -> loc -> t*", formed}}, rules,
                signature);
}

}  // namespace continua
