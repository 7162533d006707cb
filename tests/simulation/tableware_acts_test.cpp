// The hand with plates, cups and knives: gripped by an edge, by the sides, or across, and put where people
// put them.
#include "support/stage.h"

using namespace continua;
using Status = ActReport::Status;

namespace {

Stage place_setting(const std::vector<ObjectOverride>& overrides = {}) {
  return Stage(shipped_scene("place_setting", overrides));
}

}  // namespace

TEST_CASE("a form tells where fingers find hold") {
  const Scene scene = shipped_scene("place_setting");
  const auto shape = [&](const std::string& name) {
    for (const auto& object : scene.objects())
      if (object.name == name) return object.shape;
    return ObjectShape{};
  };
  const auto edges = shape("plate").edges(0.012, 0.009, 0.03, 0.006);
  CHECK(edges.size() >= 8);
  for (const auto& edge : edges) {
    CHECK(edge.radius_m == Approx(0.096).margin(0.005));
    CHECK(edge.bottom_m == Approx(0.002).margin(1e-6));
    CHECK(edge.top_m == Approx(0.01).margin(1e-6));
  }
  CHECK(shape("cup").edges(0.012, 0.009, 0.03, 0.006).empty());
  CHECK(shape("knife").edges(0.012, 0.009, 0.03, 0.006).empty());

  const auto handle = shape("knife").slice(1, -0.05, 0.009, 0);
  REQUIRE(handle);
  CHECK(handle->max_m == Approx(0.012).margin(1e-3));
  CHECK(handle->min_m == Approx(-0.012).margin(1e-3));
  CHECK_FALSE(shape("knife").slice(1, 0.05, 0.009, 0));
  const auto blade = shape("knife").slice(1, 0.05, 0.009, -0.004);
  REQUIRE(blade);
  CHECK(blade->max_m == Approx(0.007).margin(1.5e-3));
}

TEST_CASE("a knife is put into a cup, wherever both are") {
  struct Row {
    double knife_x, knife_y, knife_yaw, cup_x, cup_y;
  };
  const Row rows[] = {
      {0.12, -0.09, 0.0, 0.28, -0.02}, {-0.16, 0.01, -0.8, 0.11, -0.18}, {0.02, 0.01, 1.5, -0.2, -0.15},
      {0.26, -0.05, 3.0, 0.04, 0.14},  {-0.27, 0.1, 2.0, -0.03, 0.05},
  };
  for (const Row& row : rows) {
    INFO("knife at " << row.knife_x << " " << row.knife_y << " turned " << row.knife_yaw << ", cup at " << row.cup_x
                     << " " << row.cup_y);
    Stage stage = place_setting({{"knife", row.knife_x, row.knife_y, {}, row.knife_yaw, false},
                                 {"cup_blue", row.cup_x, row.cup_y, {}, 0.0, false},
                                 {"plate", 0.38, 0.15, {}, 0.0, false},
                                 {"cup", 0.0, 0.24, {}, 0.0, false}});
    const ActReport end = stage.act(Capability::put, "knife", by(Relation::in, "cup_blue"));
    INFO(words_of(end.reason));
    CHECK(end.status == Status::done);
    CHECK(stage.holds(Relation::in, "knife", "cup_blue"));
    CHECK((stage.object("cup_blue").p_WO - Vec3(row.cup_x, row.cup_y, 0.05)).norm() < 0.02);
    // It stands, and leans.
    CHECK(stage.object("knife").half_extents_m.z() > 0.06);
  }
}

TEST_CASE("a plate is taken by its edge and put where it shall be, with a cup on it and a knife beside it") {
  Stage stage = place_setting();
  CHECK(stage.act(Capability::put, "plate", by(Relation::left, "cup")).status == Status::done);
  CHECK(stage.holds(Relation::left, "plate", "cup"));
  for (const auto& [x, y] : {std::pair(0.0, -0.15), std::pair(-0.3, 0.1), std::pair(-0.1, 0.15)}) {
    INFO(x << " " << y);
    const ActReport end = stage.act(Capability::put, "plate", at(x, y));
    CHECK(end.status == Status::done);
    CHECK((stage.object("plate").p_WO - Vec3(x, y, 0.01)).norm() < 0.02);
    CHECK(stage.object("plate").half_extents_m.z() == Approx(0.01));
  }
  CHECK(stage.act(Capability::put, "plate", by(Relation::in_front, "avatar")).status == Status::done);
  CHECK(stage.holds(Relation::in_front, "plate", "avatar"));
  CHECK(stage.act(Capability::put, "cup", by(Relation::on, "plate")).status == Status::done);
  CHECK(stage.holds(Relation::on, "cup", "plate"));
  CHECK(stage.act(Capability::put, "knife", by(Relation::right, "plate")).status == Status::done);
  CHECK(stage.holds(Relation::right, "knife", "plate"));
  CHECK(stage.act(Capability::put, "cup", at(0.25, -0.1)).status == Status::done);
  CHECK(stage.object("cup").p_WO.z() == Approx(0.05).margin(2e-3));
}

TEST_CASE("each thing is lifted, and when its way has been stopped, put back before another is taken") {
  const std::pair<const char*, const char*> rows[] = {{"plate", "cup"}, {"cup", "knife"}, {"knife", "plate"}};
  for (const auto& [name, other] : rows) {
    INFO(name);
    Stage stage = place_setting();
    const Vec3 before = stage.object(name).p_WO;
    CHECK(stage.act(Capability::grasp, name).status == Status::done);
    CHECK(stage.act(Capability::lift).status == Status::done);
    CHECK(stage.object(name).p_WO.z() - before.z() == Approx(0.1).margin(0.01));
    stage.tell(Capability::move, name, at(-0.05, 0.0));
    stage.run(0.4);
    CHECK(stage.act(Capability::stop).status == Status::done);
    CHECK(stage.body->snapshot().held == name);
    CHECK(stage.act(Capability::move, name, at(before.x(), before.y())).status == Status::done);
    CHECK(stage.act(Capability::ungrasp).status == Status::done);
    CHECK((stage.object(name).p_WO - before).norm() < 0.02);
    CHECK(stage.act(Capability::grasp, other).status == Status::done);
    CHECK(stage.body->snapshot().held == other);
  }
}
