#include "continua/world/world_snapshot.h"

#include "support/catch.h"

using namespace continua;

TEST_CASE("a container's hollow goes with it, and is no larger when it is turned") {
  ObjectState cup{
      "cup", {}, Vec3(0.04, 0.04, 0.05), Vec3(0.1, 0, 0.05), 0, Box{{-0.02, -0.03, -0.04}, {0.04, 0.03, 0.05}}};
  struct Row {
    double yaw;
    Vec3 min, max;
  };
  const Row rows[] = {
      {0, {0.08, -0.03, 0.01}, {0.14, 0.03, 0.1}},
      {1.5707963267948966, {0.07, -0.02, 0.01}, {0.13, 0.04, 0.1}},
      {3.141592653589793, {0.06, -0.03, 0.01}, {0.12, 0.03, 0.1}},
      {0.7853981633974483, {0.0859, -0.0141, 0.01}, {0.1283, 0.0283, 0.1}},
  };
  for (const auto& row : rows) {
    cup.yaw = row.yaw;
    CHECK(cup.interior_W()->min.isApprox(row.min, 1e-9));
    CHECK(cup.interior_W()->max.isApprox(row.max, 1e-9));
  }
  cup.interior.reset();
  CHECK_FALSE(cup.interior_W());
}
