#include "continua/simulation/grip_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "continua/core/angles.h"
#include "continua/simulation/hand_route.h"
#include "continua/simulation/stacks.h"

namespace continua {

namespace {

constexpr double least_conflict_m = 1e-4;  // positions lie on a grid: a smaller conflict is a touch

// A tilted hand takes things that bear others, and things below something high.
constexpr std::array tilts = {0.0, 0.7, -0.7};
// In half lengths from the middle: a neighbour may cover the rest of a face.
constexpr std::array shifts = {0.0, 0.35, -0.35, 0.6, -0.6};
// Air between the object and each open finger.
constexpr std::array margins_m = {0.008, 0.004, 0.002};
// Air between finger tips and the support of a flat object.
constexpr double tips_air_m = 0.003;
// How steep the fingers are at an edge, best first: a flatter hand meets the table, a steeper one slips off.
constexpr std::array edge_steeps = {0.6, 0.45, 0.75};

// Costs only order the grips without a conflict. The unit is the cost of holding an object elsewhere than at its best
// part; each other weight says how much of that advantage a grip gives away.
constexpr double elsewhere_cost = 1;
// For each half length from the middle: gravity turns an object that hangs beside its middle.
constexpr double off_middle_cost = 0.5;
// For each metre of half width: 5 cm less between the fingers weigh as much as a tilt of the hand.
constexpr double width_cost_per_m = 8;
// For each metre that a face steps back under the pads: 4 mm weigh as much as a tilt, since pads on a step let the
// object turn.
constexpr double uneven_cost_per_m = 50;
// For each metre below the widest margin: 6 mm less air weigh less than a shift to the nearest place beside the middle,
// since the arm is exact.
constexpr double margin_cost_per_m = 20;
// For each radian: a tilted hand needs more room beside the object.
constexpr double tilt_cost_per_rad = 0.3;
// For each radian of the wrist from its natural turn: decides between grips that are otherwise equal.
constexpr double wrist_cost_per_rad = 0.02;
// For each radian that hand and object turn on the way: a turn takes time and may let the object slip.
constexpr double turn_cost_per_rad = 0.05;
// A wrist at its limit may not arrive: more than all other costs together, so it is the last resort.
constexpr double wrist_limit_cost = 10;

// An edge holds less well than two sides, like a part that is not the best.
constexpr double edge_cost = elsewhere_cost;
// For each radian between the edge's direction and the natural one: the arm has to reach round the object.
constexpr double edge_direction_cost_per_rad = 0.2;
// For each radian of the rolled wrist: the hand alone turns, so less than for the arm.
constexpr double edge_wrist_cost_per_rad = 0.05;
// For each radian from the best steepness: 9 degrees weigh as much as 45 degrees around the object.
constexpr double steep_cost_per_rad = 1;

// For each radian between the natural direction and that from which an object comes into a hollow on its end.
constexpr double aside_cost_per_rad = 0.3;
// For each radian that the wrist turns meanwhile: a long object swings below the hand.
constexpr double swing_cost_per_rad = 0.1;

/// `angle` plus the multiple of `period` that brings it nearest to `wanted`.
double nearest(double angle, double period, double wanted) {
  return angle + period * std::round((wanted - angle) / period);
}

double beyond_slack(double conflict_m) { return conflict_m < least_conflict_m ? 0 : conflict_m; }

bool is_square(const ObjectState& object) {
  constexpr double square_m = 1e-3;  // no hand tells a smaller difference
  return std::abs(object.half_extents_m.x() - object.half_extents_m.y()) < square_m;
}

/// The object between the fingers, in its own frame but level with W: half its width there, and the middle.
struct Span {
  double half_m = 0, middle_m = 0;
  double uneven_m = 0;  ///< depth of steps in its faces within the fingers' width
};

/// The object's span along side x (0) or y (1) between fingers at `shift_m` along the other side, with their tips at
/// `tips_m`. Nothing if the fingers would close on nothing.
std::optional<Span> span_at(const ObjectState& object, const ObjectShape* shape, const HandShape& hand, int side,
                            double shift_m, double tips_m) {
  constexpr double hold_m = 0.002;  // so much of a face above the finger tips is enough to press on
  constexpr double same_m = 0.002;  // the width of a shape's column: nearer than that to the box is the box
  const double half = object.half_extents_m[side];
  if (!shape) return Span{half, 0, 0};
  const auto slice = shape->slice(side, shift_m, hand.finger_half_width_m, tips_m + hold_m);
  if (!slice) return std::nullopt;
  Span span{(slice->max_m - slice->min_m) / 2, (slice->max_m + slice->min_m) / 2};
  constexpr double third = 1.0 / 3;
  for (const double part : {-2 * third, 0.0, 2 * third}) {
    const double width_m = hand.finger_half_width_m;
    const auto thin = shape->slice(side, shift_m + part * width_m, third * width_m, tips_m + hold_m);
    const double step_m = thin ? std::max(slice->max_m - thin->max_m, thin->min_m - slice->min_m) : span.half_m;
    span.uneven_m = std::max(span.uneven_m, step_m);
  }
  const bool as_box = std::abs(slice->max_m - half) < same_m && std::abs(slice->min_m + half) < same_m;
  return as_box ? Span{half, 0, span.uneven_m} : span;
}

/// Obstacles for the hand as columns from above; the container `into` has its hollow open.
std::vector<OrientedBox> obstacles(const std::vector<const ObjectState*>& others, const std::string& into) {
  std::vector<OrientedBox> boxes;
  for (const ObjectState* other : others) {
    if (other->name != into || !other->interior) {
      boxes.push_back(column_of(*other));
      continue;
    }
    const OrientedBox whole = box_of(*other);
    for (const int axis : {0, 1}) {
      for (const bool low : {true, false}) {
        OrientedBox wall = whole;
        const double from = low ? -whole.half_m[axis] : other->interior->max[axis];
        const double to = low ? other->interior->min[axis] : whole.half_m[axis];
        wall.half_m[axis] = (to - from) / 2;
        wall.center_W += whole.R_WB.col(axis) * (from + to) / 2;
        boxes.push_back(wall);
      }
    }
  }
  return boxes;
}

std::vector<const ObjectState*> others_of(const ObjectState& object, const WorldSnapshot& world) {
  std::vector<const ObjectState*> others;
  for (const auto& other : world.objects)
    if (other.name != object.name) others.push_back(&other);
  return others;
}

/// Adds the grips from above on two sides.
void add_grips_from_above(const ObjectState& object, const WorldSnapshot& world, const AvatarForm& avatar,
                          const ObjectShape* shape, const Box* part, std::vector<Grip>& grips) {
  const HandShape& hand = avatar.hand;
  const auto others = obstacles(others_of(object, world), "");
  // At mid height; higher on flat things, so that the finger tips stay above the support.
  const double height = std::max(0.0, hand.finger_tip_m + tips_air_m - object.half_extents_m.z());
  const double natural = avatar.natural_yaw(object.p_WO);
  for (const int side : {0, 1}) {
    const double across = side == 0 ? object.half_extents_m.y() : object.half_extents_m.x();
    const double yaw = nearest(object.yaw + side * quarter_turn, 2 * quarter_turn, natural);
    const Vec3 closing(std::cos(yaw), std::sin(yaw), 0), sideways(-std::sin(yaw), std::cos(yaw), 0);
    const Eigen::AngleAxisd R_WO(object.yaw, Vec3::UnitZ());
    // Shifts of the fingers go along the object or its part, from the middle.
    const double middle = part ? part->center()[1 - side] : 0;
    const double length = part ? (part->max - part->min)[1 - side] / 2 : across;
    const double along = (R_WO.inverse() * sideways)[1 - side];
    for (const double margin_m : margins_m) {
      for (const double shift : shifts) {
        const double shift_m = middle + shift * length * along;
        const Vec3 shift_W = shift_m * along * sideways;
        const auto span = span_at(object, shape, hand, side, shift_m, height - hand.finger_tip_m);
        if (!span) continue;
        const double opening_m = span->half_m + margin_m;
        if (opening_m > hand.widest_opening_m) continue;
        const Vec3 middle_W = R_WO * (span->middle_m * (side == 0 ? Vec3::UnitX() : Vec3::UnitY()));
        for (const double tilt : tilts) {
          Grip grip;
          grip.hand = {yaw, tilt};
          grip.p_OT = Vec3(0, 0, height) + shift_W + middle_W;
          grip.opening_m = opening_m;
          grip.conflict_m =
              beyond_slack(hand_conflict(avatar.hand, hand_at(grip, object.p_WO, false), opening_m, others));
          grip.cost = off_middle_cost * std::abs(shift) + width_cost_per_m * span->half_m +
                      uneven_cost_per_m * span->uneven_m + margin_cost_per_m * (margins_m[0] - margin_m) +
                      tilt_cost_per_rad * std::abs(tilt) + wrist_cost_per_rad * std::abs(yaw - natural);
          grips.push_back(grip);
        }
      }
    }
  }
}

/// Adds the grips with one finger below an edge and the other above. In the vertical plane through the object's centre
/// and the edge, r outward and z up, the fingers point along d = (-cos s, -sin s) and close along n = (-sin s, cos s),
/// where s is how steep they are: the upper one's tip comes to touch the top, `inset_m` from the edge, the lower one
/// the edge from below.
void add_grips_on_edges(const ObjectState& object, const WorldSnapshot& world, const AvatarForm& avatar,
                        const ObjectShape& shape, std::vector<Grip>& grips) {
  constexpr double inset_m = 0.012, margin_m = 0.003, thickest_m = 0.03, air_m = 0.006, above_table_m = 0.001;
  const HandShape& hand = avatar.hand;
  auto others = obstacles(others_of(object, world), "");
  others.push_back(table_block(world.table));
  const double natural = avatar.natural_yaw(object.p_WO);
  for (const auto& edge : shape.edges(inset_m, hand.finger_half_width_m, thickest_m, air_m)) {
    const double direction = object.yaw + edge.direction;
    const Vec3 out(std::cos(direction), std::sin(direction), 0);
    const double yaw = nearest(std::atan2(-out.x(), out.y()), 4 * quarter_turn, natural);  // ahead is inward
    for (const double steep : edge_steeps) {
      const double c = std::cos(steep), s = std::sin(steep);
      const double half_m = (inset_m * s + (edge.top_m - edge.bottom_m) * c) / 2, opening_m = half_m + margin_m;
      const double r = edge.radius_m - inset_m + hand.finger_tip_m * c + half_m * s;
      const double z = edge.top_m + hand.finger_tip_m * s - half_m * c;
      const double lowest = z - hand.finger_tip_m * s - (opening_m + hand.finger_thickness_m) * c;
      if (lowest < shape.bottom_m() + above_table_m || opening_m > hand.widest_opening_m) continue;
      for (const double roll : {quarter_turn, -quarter_turn}) {
        Grip grip;
        grip.hand = {yaw, quarter_turn - steep, roll};
        grip.p_OT = r * out + Vec3(0, 0, z);
        grip.opening_m = opening_m;
        const Pose X_WT = hand_at(grip, object.p_WO, false);
        grip.conflict_m = beyond_slack(std::max(hand_conflict(avatar.hand, X_WT, opening_m, others),
                                                hand_conflict(avatar.hand, before_grasp(X_WT), opening_m, others)));
        grip.cost = edge_cost + edge_direction_cost_per_rad * std::abs(yaw - natural) +
                    edge_wrist_cost_per_rad * std::abs(yaw + roll - natural) +
                    steep_cost_per_rad * std::abs(steep - edge_steeps[0]);
        grips.push_back(grip);
      }
    }
  }
}

/// Conflict of the hand at the goal, with the way there and back.
double conflict_at_goal(const Grip& grip, const Vec3& p_WG, const HandShape& hand,
                        const std::vector<OrientedBox>& others) {
  const Pose X_WT = hand_at(grip, p_WG, true);
  const double conflict_m = hand_conflict(hand, X_WT, grip.opening_m, others);
  if (is_level(X_WT.R_WB)) return beyond_slack(conflict_m);
  return beyond_slack(std::max(conflict_m, hand_conflict(hand, before_grasp(X_WT), grip.opening_m, others)));
}

/// Distance from the hollow's middle that a thing on its end can have.
double room_in(const ObjectState& object, const ObjectState& container) {
  const Box hollow = container.interior_W().value_or(container.bounds_W());
  const Vec3 half = (hollow.max - hollow.min) / 2;
  return std::max(0.0, std::min(half.x(), half.y()) - object.half_extents_m.z());
}

/// Angle by which it can lean there, from one side of the hollow's floor to the opposite rim.
double lean_in(const ObjectState& object, const ObjectState& container) {
  constexpr double most = 0.45;  // radians: a wide hollow shall not make the object lie
  constexpr double part = 0.9;   // of the room, so that the object does not rub on the rim
  const Box hollow = container.interior_W().value_or(container.bounds_W());
  return std::min(most, std::atan2(part * 2 * room_in(object, container), hollow.max.z() - hollow.min.z()));
}

}  // namespace

Pose hand_at(const Grip& grip, const Vec3& p_WO, bool turned) {
  if (!turned) return {p_WO + grip.p_OT, rotation(grip.hand)};
  const Vec3 closing_W(std::cos(grip.hand.yaw), std::sin(grip.hand.yaw), 0);
  const Eigen::Quaterniond R(Eigen::AngleAxisd(grip.turn, Vec3::UnitZ()) * Eigen::AngleAxisd(-grip.tip, closing_W));
  return {p_WO + grip.aside_W + R * grip.p_OT, R * rotation(grip.hand)};
}

double straightened(double yaw) { return nearest(0, quarter_turn, yaw); }

std::vector<Grip> grips_on(const ObjectState& object, const WorldSnapshot& world, const AvatarForm& avatar,
                           const ObjectShape* shape, const std::vector<std::string>& parts) {
  // The shape is known of upright objects only.
  const bool upright = shape && std::abs(shape->bottom_m() + object.half_extents_m.z()) < 2 * position_grid_m;
  std::vector<Grip> grips;
  add_grips_from_above(object, world, avatar, upright ? shape : nullptr, nullptr, grips);
  if (const Box* part = upright ? shape->part(parts) : nullptr) {
    for (Grip& grip : grips) grip.cost += elsewhere_cost;
    add_grips_from_above(object, world, avatar, shape, part, grips);
  }
  if (upright) add_grips_on_edges(object, world, avatar, *shape, grips);
  std::stable_sort(grips.begin(), grips.end(), [](const Grip& a, const Grip& b) { return a.cost < b.cost; });
  return grips;
}

std::vector<Grip> grips_at(const Grip& grip, const ObjectState& object, const Vec3& p_WG, const WorldSnapshot& world,
                           const AvatarForm& avatar, const std::string& into) {
  const auto others = obstacles(apart_from(object, world), into);
  const double straighten = straightened(object.yaw) - object.yaw;
  const double start_wrist = std::remainder(grip.hand.yaw - avatar.natural_yaw(object.p_WO), 4 * quarter_turn);
  const double yaw = avatar.natural_yaw(object.p_WO) + start_wrist;
  std::vector<Grip> grips;
  for (const int quarters : {0, 1, -1, 2, -2}) {
    if (quarters % 2 != 0 && !is_square(object)) continue;
    Grip turned = grip;
    turned.turn = straighten + quarters * quarter_turn;
    const double wrist = yaw + turned.turn - avatar.natural_yaw(p_WG);
    if (quarters != 0 && !avatar.wrist_turns(wrist)) continue;
    turned.conflict_m = std::max(grip.conflict_m, conflict_at_goal(turned, p_WG, avatar.hand, others));
    turned.cost += turn_cost_per_rad * std::abs(turned.turn) + wrist_cost_per_rad * std::abs(wrist) +
                   (avatar.wrist_turns(wrist) ? 0 : wrist_limit_cost);
    grips.push_back(turned);
  }
  return grips;
}

std::vector<Grip> grips_on_end(const Grip& grip, const ObjectState& object, const Vec3& p_WG,
                               const WorldSnapshot& world, const AvatarForm& avatar, const std::string& into) {
  constexpr double near_end = 0.3;       // of the half length: the longer part hangs down
  constexpr double along_fingers = 0.1;  // cosine: the fingers close across the long side
  constexpr std::array asides = {0.0, 0.4, -0.4, 0.8, -0.8, 1.2, -1.2, 1.6, -1.6};
  const bool along_x = object.half_extents_m.x() >= object.half_extents_m.y();
  const double half_m = std::max(object.half_extents_m.x(), object.half_extents_m.y());
  const double long_yaw = object.yaw + (along_x ? 0 : quarter_turn);
  const Vec3 long_W(std::cos(long_yaw), std::sin(long_yaw), 0);
  const Vec3 closing_W(std::cos(grip.hand.yaw), std::sin(grip.hand.yaw), 0), ahead_W(closing_W.y(), -closing_W.x(), 0);
  const double held_ahead_m = grip.p_OT.dot(ahead_W);
  if (grip.hand.roll != 0 || std::abs(closing_W.dot(long_W)) > along_fingers ||
      std::abs(held_ahead_m) < near_end * half_m)
    return {};

  const auto others = obstacles(apart_from(object, world), into);
  const double side = held_ahead_m > 0 ? 1 : -1;
  const double lean = lean_in(object, *world.find(into));
  const double thick_m = object.half_extents_m.z();
  std::vector<Grip> grips;
  for (const double aside : asides) {
    Grip stood = grip;
    stood.tip = side * (quarter_turn - lean);
    const double wrist = aside + (side < 0 ? 2 * quarter_turn * (aside > 0 ? -1 : 1) : 0);
    const double start_wrist = std::remainder(grip.hand.yaw - avatar.natural_yaw(object.p_WO), 4 * quarter_turn);
    if (!avatar.wrist_turns(wrist) || !avatar.wrist_turns(start_wrist)) continue;
    stood.turn = avatar.natural_yaw(p_WG) + wrist - grip.hand.yaw;
    const Vec3 to_W = Eigen::AngleAxisd(stood.turn, Vec3::UnitZ()) * (side * ahead_W);
    stood.aside_W = (half_m * std::sin(lean) - room_in(object, *world.find(into))) * to_W;
    stood.aside_W.z() = half_m * std::cos(lean) + thick_m * std::sin(lean) - half_m;
    stood.conflict_m = std::max(grip.conflict_m, conflict_at_goal(stood, p_WG, avatar.hand, others));
    stood.cost += aside_cost_per_rad * std::abs(aside) + swing_cost_per_rad * std::abs(wrist - start_wrist);
    grips.push_back(stood);
  }
  return grips;
}

}  // namespace continua
