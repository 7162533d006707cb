#include "continua/simulation/physics_body.h"

#include <algorithm>

#include "continua/core/random.h"
#include "support/catch.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

using namespace continua;
using Status = ActReport::Status;

namespace {

const Scene& staircase() {
  static const Scene scene = load_scene(source_dir() + "/mjcf/scenes/staircase.xml").value();
  return scene;
}

/// A body, its time, and all its reports.
struct Stage {
  std::unique_ptr<PhysicsBody> body;
  SimTime now;
  WorldReport told;

  explicit Stage(const std::vector<ObjectOverride>& overrides = {}) {
    const Scene scene = overrides.empty() ? staircase() : load_scene(staircase().path(), overrides).value();
    body = PhysicsBody::create(scene).value();
  }

  void advance(double seconds) {
    now = now + SimTime::from_seconds(seconds);
    do {
      WorldReport report = body->advance(now);
      const auto append = [](auto& to, auto& from) { to.insert(to.end(), from.begin(), from.end()); };
      append(told.acts, report.acts);
      append(told.poses, report.poses);
      append(told.rests, report.rests);
      told.until = report.until;
    } while (told.until < now);
  }

  /// Lets the world go on until it is at rest; how the last act went.
  ActReport rest() {
    for (int i = 0; i < 600 && (i == 0 || !body->at_rest()); ++i) advance(0.05);
    REQUIRE(body->at_rest());
    return told.acts.empty() ? ActReport{} : told.acts.back();
  }

  ActReport act(AvatarCommand command) {
    static int id = 0;
    command.id = ++id;
    body->command(command);
    return rest();
  }

  ObjectState object(const std::string& name) const { return *body->snapshot().find(name); }

  /// Fastest motion of an object between two pose samples.
  double fastest() const {
    std::map<std::string, std::pair<SimTime, Vec3>> last;
    double fastest = 0;
    for (const auto& object : staircase().initial_snapshot().objects) last[object.name] = {SimTime{}, object.p_WO};
    for (const auto& sample : told.poses) {
      for (const auto& [name, pose] : sample.bodies) {
        if (!last.count(name)) continue;
        auto& [t, p] = last[name];
        const double seconds = std::max(1 / 30.0, std::min((sample.t - t).seconds(), 1 / 29.0));
        fastest = std::max(fastest, (pose.p_WB - p).norm() / seconds);
        last[name] = {sample.t, pose.p_WB};
      }
    }
    return fastest;
  }
};

AvatarCommand command(Capability what, const std::string& object) {
  AvatarCommand command;
  command.what = what;
  command.object = object;
  return command;
}

AvatarCommand put_at(const std::string& object, double x, double y) {
  AvatarCommand put = command(Capability::put, object);
  put.goal.p_WG = {x, y, 0};
  return put;
}

AvatarCommand put_by(const std::string& object, Relation relation, const std::string& landmark,
                     Capability what = Capability::put) {
  AvatarCommand put = command(what, object);
  put.goal.relation = relation;
  put.goal.landmarks = {landmark};
  return put;
}

}  // namespace

TEST_CASE("each block can be put somewhere, within two centimetres in nine of ten cases and never fast") {
  Random random(42);
  Stage stage;
  int puts = 0, good = 0;
  for (const auto& block : staircase().objects()) {
    for (int n = 0; n < 2; ++n) {
      const double x = -0.45 + 0.9 * random.uniform(), y = -0.1 + 0.2 * random.uniform();
      const ActReport end = stage.act(put_at(block.name, x, y));
      ++puts;
      const double off_m = (stage.object(block.name).p_WO - Vec3(x, y, 0)).head<2>().norm();
      good += off_m <= 0.02;
      if (end.status == Status::done) CHECK(off_m == Approx(end.position_error_m).margin(1e-3));
    }
  }
  CHECK(good * 10 >= puts * 9);
  CHECK(stage.fastest() < 3);
}

TEST_CASE("blocks can be stacked, and set beside each other") {
  Stage stage;
  CHECK(stage.act(put_by("block4", Relation::on, "block1")).status == Status::done);
  CHECK(stage.act(put_by("block7", Relation::on, "block4")).status == Status::done);
  CHECK(stage.object("block4").p_WO.z() == Approx(0.09).margin(1e-3));
  CHECK(stage.object("block7").p_WO.z() == Approx(0.15).margin(1e-3));
  CHECK((stage.object("block7").p_WO - stage.object("block1").p_WO).head<2>().norm() < 0.01);

  CHECK(stage.act(put_by("block6", Relation::left, "block1", Capability::slide)).status == Status::done);
  const Vec3 apart = stage.object("block6").p_WO - stage.object("block1").p_WO;
  CHECK(apart.x() == Approx(0.06).margin(0.005));
  CHECK(apart.y() == Approx(0).margin(0.005));
}

TEST_CASE("a block put where another stands comes to its goal all the same") {
  Stage stage;
  const Vec3 p = stage.object("block1").p_WO;
  for (const double off_m : {0.01, 0.035, 0.055}) {
    const ActReport end = stage.act(put_at("block4", p.x() + off_m, p.y()));
    CHECK(end.status == Status::done);
    CHECK(end.position_error_m <= 0.02);
    stage.act(put_at("block4", -0.2, 0));
  }
}

TEST_CASE("grasp holds, lift raises, ungrasp sets down") {
  Stage stage;
  const Vec3 before = stage.object("block3").p_WO;
  CHECK(stage.act(command(Capability::grasp, "block3")).status == Status::done);
  CHECK(stage.body->snapshot().held == "block3");
  CHECK((stage.object("block3").p_WO - before).norm() < 2e-3);
  AvatarCommand lift = command(Capability::lift, "block3");
  lift.height_m = 0.1;
  CHECK(stage.act(lift).status == Status::done);
  CHECK(stage.object("block3").p_WO.z() == Approx(0.13).margin(2e-3));
  CHECK(stage.body->snapshot().held == "block3");
  CHECK(stage.act(command(Capability::ungrasp, "")).status == Status::done);
  CHECK(stage.body->snapshot().held.empty());
  CHECK(stage.object("block3").p_WO.z() == Approx(0.03).margin(1e-3));
}

TEST_CASE("grasping another object lets go of the one in the hand") {
  Stage stage;
  stage.act(command(Capability::grasp, "block3"));
  CHECK(stage.act(command(Capability::grasp, "block4")).status == Status::done);
  CHECK(stage.body->snapshot().held == "block4");
}

TEST_CASE("what cannot be done is told, and the avatar can go on") {
  Stage stage({ObjectOverride{"block6", 0.3, -1.2, -0.2664, {}, false}});
  CHECK(stage.act(command(Capability::reach, "block6")).status == Status::unreachable);
  CHECK(stage.act(put_at("block6", 0, 0)).status == Status::unreachable);
  CHECK(stage.act(put_at("block4", 3, 0)).status == Status::blocked);
  CHECK(stage.act(put_by("block4", Relation::on, "block4")).status == Status::blocked);
  CHECK(stage.act(command(Capability::grasp, "nothing")).status == Status::unreachable);
  const ActReport end = stage.act(command(Capability::lift, ""));
  CHECK(end.status == Status::blocked);
  CHECK_FALSE(end.reason.empty());
  CHECK(stage.act(put_at("block4", 0.1, -0.05)).status == Status::done);
}

TEST_CASE("a newer reach takes the place of an older one, acts wait, looks do not") {
  Stage stage;
  stage.body->command(command(Capability::reach, "block3"));
  stage.advance(0.2);
  stage.body->command(command(Capability::point, "block5"));
  stage.advance(0.2);
  REQUIRE(stage.told.acts.size() == 3);
  CHECK(stage.told.acts[1].status == Status::done);
  CHECK_FALSE(stage.told.acts[1].reason.empty());
  stage.body->command(command(Capability::lift, "block5"));
  stage.body->command(command(Capability::look, "block1"));
  stage.advance(0.01);
  REQUIRE(stage.told.acts.size() == 5);
  CHECK(stage.told.acts[4].status == Status::done);
  stage.rest();
  CHECK(stage.told.acts.size() == 8);
}

TEST_CASE("the same commands at the same times give the same poses, bit for bit") {
  Stage a, b;
  for (Stage* stage : {&a, &b}) {
    stage->body->command(put_at("block4", 0.1, 0.03));
    stage->advance(1.3);
    stage->body->command(put_by("block1", Relation::on, "block4"));
    for (int i = 0; i < 30; ++i) stage->advance(i % 2 ? 0.0377 : 0.1);
  }
  REQUIRE(a.told.poses.size() == b.told.poses.size());
  bool same = true;
  for (std::size_t i = 0; i < a.told.poses.size(); ++i) {
    same = same && a.told.poses[i].t == b.told.poses[i].t &&
           a.told.poses[i].bodies.size() == b.told.poses[i].bodies.size();
    for (const auto& [name, pose] : a.told.poses[i].bodies) {
      const Pose& other = b.told.poses[i].bodies.at(name);
      same = same && pose.p_WB == other.p_WB && pose.R_WB.coeffs() == other.R_WB.coeffs();
    }
  }
  CHECK(same);
}

TEST_CASE("the world rests when nothing moves, and time jumps") {
  Stage stage;
  stage.act(put_at("block4", 0.1, 0.03));
  const auto poses = stage.told.poses.size();
  stage.advance(3600);
  CHECK(stage.told.poses.size() == poses);
  REQUIRE_FALSE(stage.told.rests.empty());
  CHECK(stage.told.rests.back().to == stage.now);
  CHECK((stage.told.rests.back().to - stage.told.rests.back().from).seconds() > 3599);
  for (std::size_t i = 1; i < poses; ++i) CHECK((stage.told.poses[i].t - stage.told.poses[i - 1].t).us >= 33333);
  CHECK(stage.act(put_at("block4", -0.1, 0.03)).status == Status::done);
}

TEST_CASE("the weld holds only while both pads touch") {
  auto physics = Physics::create(staircase()).value();
  Avatar avatar(*physics);
  AvatarCommand lift = command(Capability::lift, "block1");
  lift.height_m = 0.1;
  avatar.begin(lift);
  int held_steps = 0;
  while (avatar.busy()) {
    REQUIRE(physics->step(avatar.update()));
    if (physics->held() < 0) continue;
    ++held_steps;
    CHECK(physics->held() == 0);
    CHECK((physics->pad_touches(true, 0) && physics->pad_touches(false, 0)));
  }
  REQUIRE(held_steps > 100);

  // One finger is enough to lose it.
  AvatarTarget open = avatar.update();
  open.opening_m = 0.05;
  for (int i = 0; i < 100; ++i) {
    REQUIRE(physics->step(open));
    if (physics->held() >= 0) CHECK((physics->pad_touches(true, 0) && physics->pad_touches(false, 0)));
  }
  CHECK(physics->held() == -1);
}

TEST_CASE("not even a block that falls from a stack of six to the floor is fast") {
  // The highest stands over the edge of the one below, beyond its balance.
  const Scene scene = load_scene(staircase().path(), {{"block1", 0.44, 0.1, {}, 0.0, false},
                                                      {"block3", 0.44, 0.1, 0.09, 0.0, false},
                                                      {"block4", 0.44, 0.1, 0.15, 0.0, false},
                                                      {"block5", 0.44, 0.1, 0.21, 0.0, false},
                                                      {"block6", 0.44, 0.1, 0.27, 0.0, false},
                                                      {"block7", 0.44, 0.134, 0.33, 0.0, false}})
                          .value();
  auto physics = Physics::create(scene).value();
  const AvatarTarget home{{physics->arm().home, ArmVector::Zero(physics->arm().size())}, 0.02};
  bool ever_fell = false, ever_fast = false;
  for (int i = 0; i < 1500; ++i) {
    REQUIRE(physics->step(home));
    ever_fell = ever_fell || !physics->slower_than(1.5, 1000);
    ever_fast = ever_fast || !physics->slower_than(2.8, 1000);
  }
  CHECK(ever_fell);
  CHECK_FALSE(ever_fast);
  CHECK(physics->object_pose(5).p_WB.z() < 0);
}

TEST_CASE("a block among others is freed before it is taken, and its landmark stays") {
  const std::map<std::string, std::string> moved_aside = {{"block4", "block3"}, {"block3", "block4"}};
  for (const auto& [landmark, other] : moved_aside) {
    Stage stage({{"block1", 0.0, 0.028, {}, 0.0, false},
                 {"block3", 0.0605, 0.028, {}, 0.0, false},
                 {"block4", -0.013, -0.0325, {}, 0.0, false}});
    const Vec3 stays = stage.object(landmark).p_WO, goes = stage.object(other).p_WO;
    const ActReport end = stage.act(put_by("block1", Relation::on, landmark));
    CHECK(end.status == Status::done);
    CHECK(stage.object("block1").p_WO.z() == Approx(0.09).margin(1e-3));
    CHECK((stage.object(landmark).p_WO - stays).norm() < 1e-3);
    CHECK((stage.object(other).p_WO - goes).norm() > 0.01);
    CHECK(end.moved_aside == std::vector{other});
  }
}

TEST_CASE("the hand hovers clear of what stands beside the place") {
  Stage stage({{"block4", -0.3, 0.05, {}, 0.0, false},
               {"block5", -0.3, 0.05, 0.09, 0.0, false},
               {"block6", -0.3, 0.05, 0.15, 0.0, false}});
  stage.rest();
  const Vec3 before = stage.object("block6").p_WO;
  AvatarCommand reach = command(Capability::reach, "");
  reach.goal.p_WG = {-0.24, 0.05, 0};
  CHECK(stage.act(reach).status == Status::done);
  CHECK((stage.object("block6").p_WO - before).norm() < 1e-3);
}

TEST_CASE("a simulation that diverges ends the act, and the world is what it was at rest") {
  // A body that gains speed beyond measure as soon as it is stepped.
  const TemporaryFolder folder;
  std::string text = staircase().text();
  const std::string gravity = "<option gravity=\"0 0 -1e12\" ";
  text.replace(text.find("<option "), 8, gravity);
  auto body = PhysicsBody::create(load_scene(folder.file("diverging.xml", text)).value()).value();
  const WorldSnapshot before = body->snapshot();
  body->command(put_at("block4", 0.1, 0));
  REQUIRE(body->advance(SimTime::from_seconds(60)).acts.size() == 1);
  WorldReport report = body->advance(SimTime::from_seconds(60));
  REQUIRE(report.acts.size() == 1);
  CHECK(report.until == report.acts[0].t);
  CHECK(report.acts[0].status == Status::dropped);
  CHECK(report.acts[0].reason.code == ReasonCode::diverged);
  CHECK(body->at_rest());
  CHECK(body->snapshot().find("block4")->p_WO == before.find("block4")->p_WO);
  report = body->advance(SimTime::from_seconds(60));
  REQUIRE_FALSE(report.rests.empty());
  CHECK(report.rests.back().to == SimTime::from_seconds(60));
}
