// The acts of which everything else is composed, one after the other and stopped at any moment.
#include "support/stage.h"

using namespace continua;
using Status = ActReport::Status;

namespace {

const Scene& staircase() {
  static const Scene scene = shipped_scene("staircase");
  return scene;
}

}  // namespace

TEST_CASE("a put is a grasp, a move and an ungrasp, each ending an advance when it begins and when it ends") {
  Stage stage(staircase());
  stage.tell(Capability::grasp, "block4", by(Relation::on, "block1"));
  WorldReport report = stage.body->advance(SimTime::from_seconds(60));
  REQUIRE(report.acts.size() == 1);
  CHECK(report.acts[0].status == Status::started);
  CHECK(report.until == SimTime());
  report = stage.body->advance(SimTime::from_seconds(60));
  REQUIRE(report.acts.size() == 1);
  CHECK(report.acts[0].status == Status::done);
  CHECK(report.until == report.acts[0].t);
  CHECK(report.until < SimTime::from_seconds(10));
  stage.now = report.until;

  CHECK(stage.act(Capability::move, "block4", by(Relation::on, "block1")).status == Status::done);
  CHECK(stage.held() == "block4");
  CHECK(stage.place("block4").z() == Approx(0.09).margin(2e-3));
  CHECK(stage.ends.back().position_error_m < 0.01);
  CHECK(stage.act(Capability::ungrasp).status == Status::done);
  CHECK(stage.held().empty());
  CHECK(stage.place("block4").z() == Approx(0.09).margin(1e-3));
  CHECK((stage.place("block4") - stage.place("block1")).head<2>().norm() < 0.01);
}

TEST_CASE("what is held can be moved again and slid, and only what is held can be moved") {
  Stage stage(staircase());
  CHECK(stage.act(Capability::move, "block4", at(0.1, 0)).status == Status::blocked);
  CHECK(stage.act(Capability::move, "", at(0.1, 0)).status == Status::blocked);
  CHECK(stage.act(Capability::grasp, "block4", at(3, 0)).status == Status::blocked);
  CHECK(stage.held().empty());
  CHECK(stage.act(Capability::grasp, "block4").status == Status::done);
  CHECK(stage.act(Capability::grasp, "block4", at(0.1, 0)).status == Status::done);
  CHECK(stage.act(Capability::move, "block4", at(0.1, -0.05)).status == Status::done);
  CHECK(stage.act(Capability::slide, "", at(0.15, 0)).status == Status::done);
  CHECK(stage.held() == "block4");
  CHECK((stage.place("block4") - Vec3(0.15, 0, 0.03)).norm() < 5e-3);
}

TEST_CASE("a stop at any moment leaves an arm that stands, and that takes commands") {
  for (const double after_s : {0.3, 1.1, 1.3, 1.5, 1.9, 2.6, 2.9, 3.2, 3.6}) {
    INFO("after " << after_s << " s");
    Stage stage(staircase());
    stage.tell(Capability::put, "block4", at(0.1, 0.03));
    stage.tell(Capability::reach, "block1");
    stage.run(after_s);
    const bool was_held = stage.held() == "block4";
    stage.ends.clear();
    const SimTime before = stage.now;
    const bool was_over = stage.body->at_rest();
    CHECK(stage.act(Capability::stop).status == Status::done);
    CHECK((stage.ends.back().t - before).seconds() < 1.5);
    if (!was_over) {
      CHECK(stage.ends.size() >= 2);
      for (std::size_t i = 0; i + 1 < stage.ends.size(); ++i) CHECK(stage.ends[i].status == Status::stopped);
    }
    // The fingers may just have begun to open, or touched it.
    if (was_held && stage.held().empty()) CHECK(stage.place("block4").z() < 0.032);

    const Vec3 stopped_at = stage.place("block4");
    stage.now = stage.now + SimTime::from_seconds(1);
    stage.body->advance(stage.now);
    CHECK((stage.place("block4") - stopped_at).norm() < 1e-3);

    CHECK(stage.act(Capability::put, "block4", at(-0.22, 0.044)).status == Status::done);
    CHECK(stage.act(Capability::grasp, "block1").status == Status::done);
    CHECK(stage.held() == "block1");
    CHECK(stage.place("block4").z() == Approx(0.03).margin(1e-3));
  }
}

TEST_CASE("what is held in mid-air is put where it is in nobody's way before another thing is taken") {
  Stage stage(staircase());
  stage.act(Capability::grasp, "block4", by(Relation::on, "block1"));
  stage.tell(Capability::move, "block4", by(Relation::on, "block1"));
  for (int i = 0; i < 400 && (stage.place("block4") - stage.place("block1")).head<2>().norm() > 0.02; ++i)
    stage.run(0.01);
  CHECK(stage.act(Capability::stop).status == Status::done);
  CHECK(stage.held() == "block4");
  CHECK(stage.place("block4").z() > 0.091);
  CHECK(stage.act(Capability::grasp, "block7").status == Status::done);
  CHECK(stage.held() == "block7");
  CHECK(stage.place("block4").z() == Approx(0.03).margin(1e-3));
  CHECK((stage.place("block1") - staircase().initial_snapshot().find("block1")->p_WO).norm() < 2e-3);
}
