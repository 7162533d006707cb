#include "continua/body/placement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "continua/body/standing.h"

namespace continua {

namespace {

// Air beside the landmark: enough for a hand, and little enough for world/relations.
constexpr double beside_gap_m = 0.02, near_gap_m = 0.05, at_gap_m = 0.005, step_gap_m = 0.02, edge_gap_m = 0.03;
// Least margin of the relation, so that a measurement still confirms it.
constexpr double least_margin_m = 5e-4;
// Distance of an object's centre from the edge of its support.
constexpr double rim_m = 0.006;

constexpr std::array sides = {Relation::left, Relation::right, Relation::in_front, Relation::behind};

/// A relation in words: "in front".
std::string in_words(Relation relation) {
  std::string words(name_of(relation));
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

Vec3 half_of(const Box& box) { return (box.max - box.min) / 2; }

/// The point is over the box, at least `rim` from its edge.
bool is_over(const Box& box, const Vec3& p_W, double rim) {
  return p_W.x() > box.min.x() + rim && p_W.x() < box.max.x() - rim && p_W.y() > box.min.y() + rim &&
         p_W.y() < box.max.y() - rim;
}

/// Steps on a grid around a place, shortest first, at most `farthest_m` long.
std::vector<Vec3> steps_around(double farthest_m) {
  constexpr double step_m = 0.005;
  const int most = static_cast<int>(std::lround(farthest_m / step_m));
  std::vector<std::array<int, 3>> steps;
  for (int y = -most; y <= most; ++y)
    for (int x = -most; x <= most; ++x)
      if (x * x + y * y <= most * most) steps.push_back({x * x + y * y, y, x});
  std::sort(steps.begin(), steps.end());
  std::vector<Vec3> found;
  for (const auto& [distance, y, x] : steps) found.emplace_back(x * step_m, y * step_m, 0);
  return found;
}

/// The search for one object's place.
class Places {
 public:
  Places(const ObjectState& object, const Goal& goal, const WorldSnapshot& world, const Reaches& reaches)
      : object_(object), goal_(goal), world_(world), reaches_(reaches), carried_(carried_with(object.name, world)) {
    for (const auto& name : goal.landmarks) {
      landmarks_.push_back(*Landmark::named(name, world));
      if (name != object.name) continue;
      // A step: the landmark is the object where it stands now.
      before_ = object;
      before_.name.clear();
      landmarks_.back().thing = &before_;
    }
  }

  OrReason<Placement> find(Occupied occupied) const;

 private:
  Reason no_room() const;
  OrReason<Placement> at_point() const;
  OrReason<Placement> in_hollow() const;
  OrReason<Placement> on_top(Occupied occupied) const;
  OrReason<Placement> nearby(Occupied occupied) const;
  std::optional<Placement> nearest(const std::vector<Vec3>& centers, Occupied occupied, bool whole,
                                   const Reaches& reaches) const;

  std::vector<Vec3> ideals() const;
  Vec3 before_participant(Perspective who, double inwards_m) const;
  std::vector<std::string> contents_of(const ObjectState& container) const;
  bool is_narrow(const ObjectState& below) const;
  double support_height(const Vec3& p_W, Occupied occupied) const;
  bool free(const ObjectState& placed) const;
  bool on_table(const ObjectState& placed) const;
  bool holds(const ObjectState& placed) const {
    return holds_by(*goal_.relation, placed, landmarks_, world_.table, goal_.perspective) >= least_margin_m;
  }
  ObjectState placed(const Vec3& p_WO) const {
    ObjectState there = object_;
    there.p_WO = on_grid(p_WO);
    return there;
  }
  /// The object on its support there.
  ObjectState standing(Vec3 p_W, Occupied occupied) const {
    p_W.z() = support_height(p_W, occupied) + object_.half_extents_m.z();
    return placed(p_W);
  }
  bool is_step() const { return landmarks_.front().thing == &before_; }

  const ObjectState& object_;
  const Goal& goal_;
  const WorldSnapshot& world_;
  const Reaches& reaches_;
  std::vector<bool> carried_;
  std::vector<Landmark> landmarks_;
  ObjectState before_;
};

Reason Places::no_room() const { return reason_about_goal(ReasonCode::no_room, object_.name, goal_); }

/// There is room for the object and for everything that moves along with it.
bool Places::free(const ObjectState& placed) const {
  const Vec3 by_W = placed.p_WO - object_.p_WO;
  for (std::size_t i = 0; i < carried_.size(); ++i) {
    if (!carried_[i]) continue;
    ObjectState moved = world_.objects[i].name == placed.name ? placed : world_.objects[i];
    if (moved.name != placed.name) moved.p_WO += by_W;
    for (std::size_t j = 0; j < carried_.size(); ++j)
      if (!carried_[j] && overlap(moved, world_.objects[j])) return false;
  }
  return true;
}

bool Places::on_table(const ObjectState& placed) const {
  const Box box = placed.bounds_W();
  return box.min.x() >= world_.table.min.x() - grid_slack_m && box.max.x() <= world_.table.max.x() + grid_slack_m &&
         box.min.y() >= world_.table.min.y() - grid_slack_m && box.max.y() <= world_.table.max.y() + grid_slack_m;
}

/// The object would fall off that thing.
bool Places::is_narrow(const ObjectState& below) const {
  const Vec3 mine = half_of(object_.bounds_W()), theirs = half_of(below.bounds_W());
  return theirs.x() < mine.x() / 2 || theirs.y() < mine.y() / 2;
}

/// Height of the object's support beside the landmark: the table, or the highest wide enough thing that is no higher
/// than the support of the landmark.
double Places::support_height(const Vec3& p_W, Occupied occupied) const {
  constexpr double slack_m = 0.01;
  double height = world_.table.max.z();
  if (!landmarks_.front().thing) return height;
  const double bottom = landmarks_.front().bounds_W.min.z();
  for (std::size_t i = 0; i < world_.objects.size(); ++i) {
    const auto& other = world_.objects[i];
    if (other.name == object_.name || other.name == landmarks_.front().thing->name) continue;
    const Box box = other.bounds_W();
    if (occupied == Occupied::avoided && (carried_[i] || is_narrow(other))) continue;
    if (is_over(box, p_W, 0) && box.max.z() <= bottom + slack_m) height = std::max(height, box.max.z());
  }
  return height;
}

/// The place on a participant's side of the table, near its edge, or farther inwards.
Vec3 Places::before_participant(Perspective who, double inwards_m) const {
  const Vec3 half = half_of(object_.bounds_W()), front = side_W(Relation::in_front, who);
  Vec3 p = world_.table.center() + front * (half_of(world_.table).y() - edge_gap_m - half.y() - inwards_m);
  if (*goal_.relation == Relation::left || *goal_.relation == Relation::right)
    p += side_W(*goal_.relation, who) * half_of(world_.table).x() / 2;
  return p;
}

/// Centres of the search, nearest to the object first.
std::vector<Vec3> Places::ideals() const {
  const Relation relation = *goal_.relation;
  const Landmark& landmark = landmarks_.front();
  if (relation == Relation::between) return {(landmark.bounds_W.center() + landmarks_[1].bounds_W.center()) / 2};
  if (landmark.who) return {before_participant(*landmark.who, 0)};
  // Extents along the world's axes: an object may be turned.
  const Box mine = object_.bounds_W();
  const Vec3 reach = (mine.max - mine.min + landmark.bounds_W.max - landmark.bounds_W.min) / 2;
  const auto beside = [&](Relation side, double gap_m) -> Vec3 {
    const Vec3 direction = side_W(side, goal_.perspective);
    return landmark.thing->p_WO + direction * (direction.cwiseAbs().dot(reach) + gap_m);
  };
  if (is_side(relation)) return {beside(relation, is_step() ? step_gap_m : 0)};
  const double gap_m = relation == Relation::near     ? near_gap_m
                       : relation == Relation::beside ? beside_gap_m
                       : relation == Relation::at     ? at_gap_m
                                                      : 0;
  std::vector<Vec3> places;
  for (const Relation side : sides) places.push_back(beside(side, gap_m));
  const auto way = [&](const Vec3& p) { return on_grid((p - object_.p_WO).head<2>().norm()); };
  std::stable_sort(places.begin(), places.end(), [&](const Vec3& a, const Vec3& b) { return way(a) < way(b); });
  // Left and right come first for `beside`.
  if (relation == Relation::beside)
    std::stable_partition(places.begin(), places.end(),
                          [&](const Vec3& p) { return std::abs(p.y() - landmark.thing->p_WO.y()) < position_grid_m; });
  return places;
}

/// A point of the table is a place whatever stands there.
OrReason<Placement> Places::at_point() const {
  const Vec3 there(goal_.p_WG.x(), goal_.p_WG.y(), world_.table.max.z() + object_.half_extents_m.z());
  if (!bears(world_.table, there)) return Reason{ReasonCode::falls_off, {object_.name}};
  return Placement{on_grid(there)};
}

/// On the floor of a container, where the object fits as it lies or on its end.
OrReason<Placement> Places::in_hollow() const {
  const ObjectState* container = landmarks_.front().thing;
  const auto hollow = container->interior_W();
  if (!hollow) return Reason{ReasonCode::no_containment, {container->name}};
  bool fits = false;
  const bool alone = std::count(carried_.begin(), carried_.end(), true) == 1;
  for (const bool upright : {false, true}) {
    if (upright && !alone) continue;
    ObjectState there = upright ? stood_on_end(object_) : object_;
    const Vec3 half = half_of(there.bounds_W()), room = half_of(*hollow) - half;
    if (room.x() < -grid_slack_m || room.y() < -grid_slack_m) continue;
    fits = true;
    for (const Vec3& step : steps_around(std::hypot(half_of(*hollow).x(), half_of(*hollow).y()))) {
      there.p_WO = on_grid(Vec3(hollow->center() + step));
      there.p_WO.z() = on_grid(hollow->min.z() + there.half_extents_m.z());
      if (is_inside(there, *container) && free(there)) return Placement{there.p_WO, upright};
    }
  }
  if (!fits) return Reason{ReasonCode::does_not_fit, {object_.name, container->name}};
  auto inside = contents_of(*container);
  if (inside.empty()) return no_room();
  inside.insert(inside.begin(), container->name);
  return Reason{ReasonCode::full, std::move(inside)};
}

/// Names of the things in a container, without the object itself.
std::vector<std::string> Places::contents_of(const ObjectState& container) const {
  std::vector<std::string> inside;
  const std::array landmarks = {Landmark::object(container)};
  for (const auto& other : world_.objects)
    if (other.name != container.name && other.name != object_.name &&
        holds_by(Relation::in, other, landmarks, world_.table, goal_.perspective) > 0)
      inside.push_back(other.name);
  return inside;
}

OrReason<Placement> Places::on_top(Occupied occupied) const {
  constexpr double farthest_m = 0.2;
  const ObjectState& below = *landmarks_.front().thing;
  const Box top = below.bounds_W();
  const Vec3 ideal(below.p_WO.x(), below.p_WO.y(), top.max.z() + object_.half_extents_m.z());
  // A support of less than a quarter of the object's width lets it tip at the least push.
  const Vec3 bearing = half_of(top), needed = (half_of(object_.bounds_W()) / 4).cwiseMax(rim_m);
  if (bearing.x() <= needed.x() || bearing.y() <= needed.y())
    return Reason{ReasonCode::too_narrow, {below.name, object_.name}};
  if (occupied == Occupied::cleared) return Placement{on_grid(ideal)};
  static const auto steps = steps_around(farthest_m);
  for (const Vec3& step : steps) {
    const ObjectState there = placed(ideal + step);
    if (!is_over(top, there.p_WO, rim_m) || !free(there) || !holds(there)) continue;
    if (is_inside(there, below)) return Reason{ReasonCode::falls_in, {object_.name, below.name}};
    return Placement{there.p_WO};
  }
  return no_room();
}

/// The place nearest to one of the centres, within reach if that is told. `whole`: with all of the object above the
/// table, else only its centre.
std::optional<Placement> Places::nearest(const std::vector<Vec3>& centers, Occupied occupied, bool whole,
                                         const Reaches& reaches) const {
  constexpr double farthest_m = 0.3;
  static const auto steps = steps_around(farthest_m);
  int tries = 400;  // of reaching, which takes some 20 microseconds
  for (const Vec3& step : steps) {
    for (const Vec3& center : centers) {
      const ObjectState there = standing(center + step, occupied);
      const bool borne = whole ? on_table(there) : bears(world_.table, there.p_WO);
      if (!borne || !free(there) || !holds(there)) continue;
      if (!reaches || reaches(there.p_WO)) return Placement{there.p_WO};
      if (--tries == 0) return std::nullopt;
    }
  }
  return std::nullopt;
}

OrReason<Placement> Places::nearby(Occupied occupied) const {
  const auto& who = landmarks_.front().who;
  const bool beside_thing = is_side(*goal_.relation) && landmarks_.front().thing && !is_step();
  auto centers = ideals();
  if (occupied == Occupied::cleared && beside_thing) return Placement{standing(centers.front(), occupied).p_WO};
  if (reaches_) {
    if (const auto place = nearest(centers, occupied, true, reaches_)) return *place;
    std::vector<Vec3> inwards;
    for (int cm = 2; who && cm <= 40; cm += 2) inwards.push_back(before_participant(*who, cm / 100.0));
    if (const auto place = nearest(inwards, occupied, true, reaches_)) return *place;
  }
  if (const auto place = nearest(centers, occupied, true, {})) return *place;
  // Beside another thing the object may stand out over the edge.
  if (beside_thing)
    if (const auto place = nearest(centers, occupied, false, {})) return *place;
  return no_room();
}

OrReason<Placement> Places::find(Occupied occupied) const {
  if (!goal_.relation) return at_point();
  const Relation relation = *goal_.relation;
  const std::string words = in_words(relation);
  if (landmarks_.size() != landmarks_of(relation)) return Reason{ReasonCode::no_landmark, {}, {words}};
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    const std::string& name = goal_.landmarks[i];
    if (name == object_.name && !is_side(relation)) return Reason{ReasonCode::itself, {name}, {words}};
    for (std::size_t j = 0; j < carried_.size(); ++j)
      if (occupied == Occupied::avoided && carried_[j] && world_.objects[j].name == name && name != object_.name)
        return Reason{ReasonCode::moves_along, {name, object_.name}};
    const bool impossible = relation == Relation::on || relation == Relation::in || relation == Relation::touching ||
                            relation == Relation::behind;
    if (relation == Relation::under || (landmarks_[i].who && impossible))
      return Reason{ReasonCode::no_place, {name}, {words}};
  }
  if (relation == Relation::in) return in_hollow();
  if (relation == Relation::on) return on_top(occupied);
  return nearby(occupied);
}

}  // namespace

Reason reason_about_goal(ReasonCode code, const std::string& object, const Goal& goal) {
  Reason reason{code, goal.landmarks, {in_words(*goal.relation)}};
  reason.objects.insert(reason.objects.begin(), object);
  return reason;
}

OrReason<Placement> placement(const AvatarCommand& command, const WorldSnapshot& world, Occupied occupied,
                              const Reaches& reaches) {
  const ObjectState* object = world.find(command.object);
  require(object && !missing_thing(command, world), "a place is sought for and beside things that are in the world");
  return Places(*object, command.goal, world, reaches).find(occupied);
}

}  // namespace continua
