#include "continua/perception/ray_cast.h"

#include <fmt/format.h>

#include "support/catch.h"

using namespace continua;

namespace {

ObjectState box(const std::string& name, double x, double y, double half_m) {
  ObjectState object;
  object.name = name;
  object.half_extents_m = Vec3(half_m, half_m, half_m);
  object.p_WO = Vec3(x, y, half_m);
  return object;
}

// The place to which a ray points in a world with a cup at (0, 0.1) and a plate-like block behind it at (0, 0.3).
std::string place(const Vec3& from_W, const Vec3& direction_W, const std::string& held = "") {
  WorldSnapshot world;
  world.objects = {box("cup", 0, 0.1, 0.05), box("block", 0, 0.3, 0.03)};
  world.held = held;
  InputEvent event;
  event.modality = Modality::pointing;
  event.ray = Ray{from_W, direction_W};
  const auto place_W = place_of(with_target(event, world));
  return place_W ? fmt::format("{:.3f} {:.3f}", place_W->x(), place_W->y()) : "nowhere";
}

}  // namespace

TEST_CASE("a ray ends at the first thing that it meets") {
  const Vec3 hand(0, -0.4, 0.35);
  CHECK(place(hand, Vec3(0, 0.45, -0.3)) == "0.000 0.050");         // the front of the cup, 5 cm high
  CHECK(place(hand, Vec3(0, 0.5, -0.25)) == "0.000 0.100");         // its top
  CHECK(place(hand, Vec3(0, 0.45, -0.3), "cup") == "0.000 0.125");  // the cup is in the gripper
  CHECK(place(hand, Vec3(0.3, 0.5, -0.35)) == "0.300 0.100");       // the table beside it
  CHECK(place(Vec3(0, 0.1, 0.5), Vec3(0, 0, -1)) == "0.000 0.100");
  CHECK(place(Vec3(0.5, 0.1, 0.5), Vec3(0, 0, 1)) == "nowhere");
  CHECK(place(Vec3(0, -0.4, 0.05), Vec3(0, 1, 0)) == "0.000 0.050");  // level
  CHECK(place(Vec3(0, 0.6, 0.05), Vec3(0, 1, 0)) == "nowhere");       // away from both
}

TEST_CASE("a target of its own counts, and an event without a ray has none") {
  WorldSnapshot world;
  world.objects = {box("cup", 0, 0.1, 0.05)};
  InputEvent event;
  CHECK_FALSE(with_target(event, world).target_W);
  event.ray = Ray{Vec3(0, -0.4, 0.35), Vec3(0, 0.45, -0.3)};
  event.target_W = Vec3(0.2, 0.2, 0);
  CHECK(with_target(event, world).target_W == Vec3(0.2, 0.2, 0));
}
