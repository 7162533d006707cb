#include "continua/simulation/handling.h"

#include <algorithm>
#include <cmath>

#include "continua/simulation/scene.h"
#include "continua/simulation/stacks.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;

namespace {

/// A hand with thin fingers, on an arm with its base behind the table.
AvatarForm thin_fingers() {
  AvatarForm avatar;
  avatar.arm.joints.push_back({{Vec3(0, 0.428, 0.42), Eigen::Quaterniond::Identity()}, Vec3::UnitZ(), -2.6, 2.6});
  avatar.hand = {0.009, 0.005, 0.02, 0.1, 0.14, 0.062, 0.022, 0.058};
  return avatar;
}
const AvatarForm avatar = thin_fingers();

ObjectState block(const std::string& name, double x, double y, int level = 0, double yaw = 0) {
  return {name, {}, Vec3::Constant(0.03), Vec3(x, y, 0.03 + 0.06 * level), yaw};
}

WorldSnapshot world_of(const std::vector<ObjectState>& objects) {
  WorldSnapshot world;
  world.table = {{-0.5, -0.12, 0}, {0.5, 0.12, 0}};
  world.objects = objects;
  return world;
}

/// The cheapest grip on the first object for which there is room.
std::optional<Grip> first_grip(const WorldSnapshot& world) {
  for (const Grip& grip : grips_on(world.objects[0], world, avatar)) {
    if (grip.conflict_m == 0) return grip;
  }
  return std::nullopt;
}

}  // namespace

TEST_CASE("how deep boxes overlap, turned or not") {
  const OrientedBox a{Vec3::Zero(), Eigen::Matrix3d::Identity(), Vec3::Constant(0.03)};
  OrientedBox b = a;
  b.center_W = {0.05, 0, 0};
  CHECK(overlap_depth(a, b) == Approx(0.01));
  b.center_W = {-0.07, 0, 0};
  CHECK(overlap_depth(a, b) == Approx(-0.01));
  b.R_WB = Eigen::AngleAxisd(0.7853981633974483, Vec3::UnitZ()).toRotationMatrix();
  CHECK(overlap_depth(a, b) == Approx(0.03 * std::sqrt(2.0) - 0.04));
  b.center_W = {0.06, 0.06, 0};  // only the turned box's own faces part them
  CHECK(overlap_depth(a, b) == Approx(0.03 - 0.03 * std::sqrt(2.0)));
  CHECK(overlap_depth(b, a) == overlap_depth(a, b));
}

TEST_CASE("what stands on a thing, and what it can meet") {
  const auto world = world_of({block("a", 0, 0), block("b", 0.02, 0, 1), block("c", 0.04, 0, 2), block("d", 0.061, 0)});
  CHECK(standing_on(world.objects[0], world) == std::vector<std::string>{"b", "c"});
  REQUIRE(apart_from(world.objects[0], world).size() == 1);
  CHECK(apart_from(world.objects[0], world)[0]->name == "d");
  CHECK(height_under(world.objects[2], world) == Approx(0.12));
}

TEST_CASE("the hand's turn is told from its rotation") {
  for (const double tilt : {-0.7, 0.0, 0.7}) {
    const HandTurn turn = turn_of(rotation({0.4, tilt}));
    CHECK(turn.yaw == Approx(0.4));
    CHECK(turn.tilt == Approx(tilt).margin(1e-9));
    CHECK(is_level(rotation({0.4, tilt})));
  }
  // A positive tilt brings the wrist, which is behind the fingers, nearer to the avatar.
  CHECK((rotation({0, 0.7}) * Vec3::UnitX()).y() < 0);
}

TEST_CASE("fingers come down where there is room") {
  const auto alone = first_grip(world_of({block("a", 0, 0)}));
  REQUIRE(alone);
  CHECK(alone->hand.yaw == Approx(0).margin(1e-9));
  CHECK(alone->hand.tilt == 0);

  const auto in_a_row = first_grip(world_of({block("a", 0, 0), block("b", 0.061, 0), block("c", -0.061, 0)}));
  REQUIRE(in_a_row);
  CHECK(std::abs(in_a_row->hand.yaw) == Approx(1.5708).margin(1e-3));

  // The palm has no room above two others: the hand tilts.
  const auto under_two = first_grip(world_of({block("a", 0, 0), block("b", 0, 0, 1), block("c", 0, 0, 2)}));
  REQUIRE(under_two);
  CHECK(under_two->hand.tilt != 0);

  CHECK_FALSE(first_grip(world_of({block("a", 0, 0), block("b", 0.061, 0), block("c", 0, -0.061)})));
}

TEST_CASE("a square thing comes to lie along the table, turned so that the fingers find room") {
  const auto world = world_of({block("a", 0.3, 0, 0, 0.3), block("b", -0.061, 0), block("c", 0.061, 0)});
  const auto grip = first_grip(world);
  REQUIRE(grip);
  const Vec3 between(0, 0, 0.03);
  int with_room = 0;
  for (const Grip& turned : grips_at(*grip, world.objects[0], between, world, avatar)) {
    CHECK(std::remainder(0.3 + turned.turn, 1.5707963267948966) == Approx(0).margin(1e-9));
    if (turned.conflict_m > 0) continue;
    ++with_room;
    CHECK(std::abs((hand_at(turned, between, true).R_WB * Vec3::UnitY()).x()) < 1e-6);
  }
  CHECK(with_room > 0);
}

TEST_CASE("ways to set a thing down: at the goal, beside it, on what is there, by a push") {
  const ObjectState a = block("a", 0.4, 0);
  const Vec3 goal(0, 0, 0.03);
  constexpr double near_m = 0.018;
  CHECK(set_downs(a, goal, world_of({a}), near_m).front().p_WO == goal);

  const auto beside = set_downs(a, goal, world_of({a, block("b", 0.05, 0)}), near_m);
  REQUIRE_FALSE(beside.empty());
  CHECK(beside.front().p_WO.x() < -0.01);
  CHECK(beside.front().p_WO.z() == Approx(0.03));

  const auto on = set_downs(a, goal, world_of({a, block("b", 0.01, 0)}), near_m);
  REQUIRE_FALSE(on.empty());
  CHECK(on.front().p_WO.isApprox(Vec3(0, 0, 0.09), 1e-9));
  // Neither of two alone would bear it, both do.
  const auto on_two = set_downs(a, goal, world_of({a, block("b", 0.035, 0), block("c", -0.035, 0)}), near_m);
  REQUIRE_FALSE(on_two.empty());
  CHECK(on_two.front().p_WO.z() == Approx(0.09));

  const auto pushed = set_downs(a, goal, world_of({a, block("b", 0.034, 0)}), near_m);
  REQUIRE_FALSE(pushed.empty());
  CHECK(pushed.front().p_WO == goal);
  REQUIRE(pushed.front().shove_from_W);
  CHECK(pushed.front().shove_from_W->x() < -0.02);
}

TEST_CASE("nothing is set down beyond the table's edge") {
  const ObjectState a = block("a", 0.4, 0);
  const auto world = world_of({a});
  const auto ways = set_downs(a, {0, 0.13, 0.03}, world, 0.018);
  REQUIRE_FALSE(ways.empty());
  for (const SetDown& way : ways) CHECK(way.p_WO.y() < world.table.max.y());
  CHECK(set_downs(a, {0, 0.2, 0.03}, world, 0.018).empty());
}

TEST_CASE("a thing is held by the component that its voxeme names, where there is room") {
  const auto scene = load_scene(source_dir() + "/mjcf/scenes/place_setting.xml").value();
  const auto knife = std::find_if(scene.objects().begin(), scene.objects().end(),
                                  [](const SceneObject& object) { return object.name == "knife"; });
  WorldSnapshot world = scene.initial_snapshot();
  std::swap(world.objects.front(), *std::find_if(world.objects.begin(), world.objects.end(),
                                                 [](const ObjectState& object) { return object.name == "knife"; }));
  const auto held_at = [&](const std::vector<std::string>& parts) {
    for (const Grip& grip : grips_on(world.objects.front(), world, avatar, &knife->shape, parts))
      if (grip.conflict_m == 0) return grip.p_OT.x();
    return 1.0;
  };
  // Not over the step between blade and handle.
  CHECK(held_at({}) == Approx(-0.0315).margin(1e-4));
  CHECK(held_at({"spout"}) == Approx(-0.0315).margin(1e-4));
  CHECK(held_at({"spout", "handle"}) == Approx(-0.0475).margin(1e-4));

  // Where something stands over the handle, it is held elsewhere.
  ObjectState board = block("board", world.objects.front().p_WO.x() - 0.07, world.objects.front().p_WO.y(), 1);
  board.half_extents_m = {0.05, 0.15, 0.03};
  world.objects.push_back(board);
  CHECK(held_at({"handle"}) > -0.02);
}
