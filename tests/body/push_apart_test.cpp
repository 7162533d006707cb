#include "continua/body/push_apart.h"

#include "continua/body/standing.h"
#include "support/catch.h"

using namespace continua;

namespace {

ObjectState block(const std::string& name, const Vec3& p_WO) { return {name, {}, Vec3::Constant(0.03), p_WO, 0}; }

WorldSnapshot world_of(std::vector<ObjectState> objects) {
  WorldSnapshot world;
  world.table = {{-0.5, -0.12, 0}, {0.5, 0.12, 0}};
  world.objects = std::move(objects);
  return world;
}

Vec3 place(const WorldSnapshot& world, const std::string& name) { return world.find(name)->p_WO; }

bool none_overlap(const WorldSnapshot& world) {
  for (std::size_t i = 0; i < world.objects.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (overlap(world.objects[i], world.objects[j])) return false;
  return true;
}

}  // namespace

TEST_CASE("two things give way by the same length, the shorter way") {
  const auto apart = pushed_apart(world_of({block("a", {0, 0, 0.03}), block("b", {0.04, 0.01, 0.03})}), "b");
  CHECK(place(apart, "a").isApprox(Vec3(-0.01, 0, 0.03)));
  CHECK(place(apart, "b").isApprox(Vec3(0.05, 0.01, 0.03)));
  const auto along_y = pushed_apart(world_of({block("a", {0, 0, 0.03}), block("b", {0.01, -0.05, 0.03})}), "b");
  CHECK(place(along_y, "a").isApprox(Vec3(0, 0.005, 0.03)));
  CHECK(place(along_y, "b").isApprox(Vec3(0.01, -0.055, 0.03)));
}

TEST_CASE("what is not overlapped stays, and touching is no overlap") {
  const auto world = world_of(
      {block("a", {0, 0, 0.03}), block("b", {0.06, 0, 0.03}), block("c", {0.2, 0, 0.03}), block("d", {0.22, 0, 0.03})});
  const auto apart = pushed_apart(world, "a");
  for (const auto& object : world.objects) CHECK(place(apart, object.name) == object.p_WO);
}

TEST_CASE("one that gives way pushes the next") {
  const auto apart = pushed_apart(
      world_of({block("a", {0, 0, 0.03}), block("b", {0.06, 0, 0.03}), block("c", {-0.02, 0, 0.03})}), "c");
  CHECK(none_overlap(apart));
  CHECK(place(apart, "b").x() > 0.06);
  CHECK(place(apart, "c").x() < -0.02);
}

TEST_CASE("in the same place there is still a way out") {
  CHECK(none_overlap(
      pushed_apart(world_of({block("a", {0, 0, 0.03}), block("b", {0, 0, 0.03}), block("c", {0, 0, 0.03})}), "b")));
}

TEST_CASE("what stands on a thing that is pushed stays, and falls if nothing is left below it") {
  const auto stays =
      pushed_apart(world_of({block("a", {0, 0, 0.03}), block("top", {0, 0, 0.09}), block("b", {0.05, 0, 0.03})}), "b");
  CHECK(place(stays, "a").x() < 0);
  CHECK(place(stays, "top").isApprox(Vec3(0, 0, 0.09)));
  // It stood on the edge.
  const auto falls = pushed_apart(
      world_of({block("a", {0, 0, 0.03}), block("top", {0, 0.059, 0.09}), block("b", {0, 0.04, 0.03})}), "b");
  CHECK(none_overlap(falls));
  CHECK(place(falls, "top").z() == Approx(0.09));  // on b, which came below it
  const auto down = pushed_apart(world_of({block("a", {0, 0, 0.03}), block("top", {0.055, 0, 0.09}),
                                           block("b", {0.005, 0.058, 0.03}), block("c", {0.03, 0, 0.03})}),
                                 "c");
  CHECK(none_overlap(down));
}

TEST_CASE("what is in a hollow goes along with it") {
  auto cup = block("cup", {0, 0, 0.03});
  cup.interior = Box{Vec3(-0.02, -0.02, -0.02), Vec3(0.02, 0.02, 0.03)};
  ObjectState spoon{"spoon", {}, Vec3(0.005, 0.005, 0.02), {0, 0, 0.03}, 0};
  const auto apart = pushed_apart(world_of({cup, spoon, block("b", {0.04, 0, 0.03})}), "b");
  CHECK(place(apart, "cup").x() == Approx(-0.01));
  CHECK(place(apart, "spoon").x() == Approx(-0.01));
}

TEST_CASE("a thing that is put down firmly stays, and the others give way") {
  const auto apart =
      pushed_apart(world_of({block("a", {0, 0, 0.03}), block("b", {0.04, 0.01, 0.03})}), "b", GivesWay::others);
  CHECK(apart.objects[1].p_WO.isApprox(Vec3(0.04, 0.01, 0.03)));
  CHECK(apart.objects[0].p_WO.x() == Approx(-0.02));
}
