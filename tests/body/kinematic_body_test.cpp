#include "continua/body/kinematic_body.h"

#include <cmath>

#include "support/catch.h"

using namespace continua;
using Status = ActReport::Status;

namespace {

ObjectState block(const std::string& name, const Vec3& p_WO) { return {name, {}, Vec3::Constant(0.03), p_WO, 0}; }

WorldSnapshot three_blocks() {
  WorldSnapshot world;
  world.table = {{-0.5, -0.12, 0}, {0.5, 0.12, 0}};
  world.objects = {block("a", {0, 0, 0.03}), block("b", {0.2, 0, 0.03}), block("c", {0.2, 0.01, 0.09})};
  return world;
}

AvatarCommand command(Capability what, const std::string& object) {
  AvatarCommand command;
  command.what = what;
  command.object = object;
  return command;
}

AvatarCommand move(Capability what, const std::string& object, Relation relation, const std::string& landmark) {
  AvatarCommand command;
  command.what = what;
  command.object = object;
  command.goal.relation = relation;
  command.goal.landmarks = {landmark};
  return command;
}

// The last of the reports until nothing is to be done any more.
WorldReport until_rest(KinematicBody& body, SimTime t) {
  WorldReport report = body.advance(t);
  while (!body.at_rest()) report = body.advance(t);
  return report;
}

ActReport act(KinematicBody& body, const AvatarCommand& command) {
  body.command(command);
  return until_rest(body, body.snapshot().t + SimTime{1}).acts.back();
}

Vec3 place(const KinematicBody& body, const std::string& name) { return body.snapshot().find(name)->p_WO; }

}  // namespace

TEST_CASE("an act that is held begins and changes nothing, and a stop ends it") {
  KinematicBody body(three_blocks());
  body.hold(true);
  body.command(command(Capability::grasp, "a"));
  CHECK(body.advance(SimTime{1}).acts.back().status == Status::started);
  const WorldReport held = body.advance(SimTime{5});
  CHECK(held.until == SimTime{5});
  CHECK(held.acts.empty());
  CHECK_FALSE(body.at_rest());
  SECTION("let go, it is done") {
    body.hold(false);
    CHECK(body.advance(SimTime{5}).acts.back().status == Status::done);
    CHECK(body.snapshot().held == "a");
  }
  SECTION("stopped, it is not") {
    body.command(command(Capability::stop, ""));
    CHECK(body.advance(SimTime{5}).acts.front().status == Status::stopped);
    CHECK(body.snapshot().held.empty());
  }
}

TEST_CASE("acts begin, and are done at the same instant, and what stands on an object moves along") {
  KinematicBody body(three_blocks());
  body.advance(SimTime{5});
  body.command(move(Capability::put, "b", Relation::on, "a"));
  CHECK_FALSE(body.at_rest());
  const WorldReport begun = body.advance(SimTime{9});
  REQUIRE(begun.acts.size() == 1);
  CHECK(begun.acts[0].status == Status::started);
  CHECK(begun.poses.empty());
  CHECK_FALSE(body.at_rest());
  const WorldReport report = body.advance(SimTime{9});
  CHECK(report.until == SimTime{5});
  CHECK(body.advance(SimTime{9}).until == SimTime{9});
  CHECK(body.at_rest());
  REQUIRE(report.acts.size() == 1);
  CHECK(report.acts[0].status == Status::done);
  CHECK(report.acts[0].t == SimTime{5});
  REQUIRE(report.poses.size() == 1);
  CHECK(report.poses[0].bodies.size() == 2);
  CHECK(place(body, "b").isApprox(Vec3(0, 0, 0.09)));
  CHECK(place(body, "c").isApprox(Vec3(0, 0.01, 0.15)));
}

TEST_CASE("grasp, lift and ungrasp") {
  KinematicBody body(three_blocks());
  CHECK(act(body, command(Capability::grasp, "c")).status == Status::done);
  CHECK(body.snapshot().held == "c");
  CHECK(place(body, "c").isApprox(Vec3(0.2, 0.01, 0.09)));
  AvatarCommand lift = command(Capability::lift, "");
  lift.height_m = 0.1;
  CHECK(act(body, lift).status == Status::done);
  CHECK(place(body, "c").z() == Approx(0.19));
  CHECK(act(body, command(Capability::ungrasp, "")).status == Status::done);
  CHECK(body.snapshot().held.empty());
  CHECK(place(body, "c").z() == Approx(0.09));
}

TEST_CASE("what is pushed is not held, what is turned lies as it is turned, and the hand may be drawn back") {
  KinematicBody body(three_blocks());
  AvatarCommand push = move(Capability::push, "a", Relation::left, "b");
  ActReport end = act(body, push);
  CHECK(end.status == Status::done);
  CHECK(end.touches == std::vector<std::string>{"b", "table"});
  CHECK(body.snapshot().held.empty());

  AvatarCommand turn = command(Capability::turn, "b");
  turn.turn_rad = 0.5;
  const Vec3 rider = place(body, "c");
  CHECK(act(body, turn).status == Status::blocked);
  act(body, push = move(Capability::push, "a", Relation::left, "a"));
  end = act(body, turn);
  CHECK(end.status == Status::done);
  CHECK(end.touches == std::vector<std::string>{"c", "table"});
  CHECK(body.snapshot().find("b")->yaw == Approx(0.5));
  CHECK(body.snapshot().find("c")->yaw == Approx(0.5));
  CHECK((place(body, "c") - rider).norm() == Approx(0.01 * 2 * std::sin(0.25)).margin(2e-4));

  act(body, command(Capability::grasp, "a"));
  CHECK(act(body, command(Capability::retract, "")).status == Status::done);
  CHECK(body.snapshot().held == "a");
  turn.object = "a";
  act(body, turn);
  CHECK(body.snapshot().held == "a");
  CHECK(act(body, command(Capability::turn, "nothing")).status == Status::unreachable);
}

TEST_CASE("a put of another object lets go of the one in the hand") {
  KinematicBody body(three_blocks());
  AvatarCommand lift = command(Capability::lift, "c");
  lift.height_m = 0.1;
  act(body, lift);
  act(body, move(Capability::put, "a", Relation::on, "c"));
  CHECK(body.snapshot().held.empty());
  CHECK(place(body, "c").z() == Approx(0.09));
  CHECK(place(body, "a").z() == Approx(0.15));
}

TEST_CASE("what stands on its end in a cup goes along with it, and lies again where it is put next") {
  WorldSnapshot world;
  world.table = {{-0.5, -0.3, 0}, {0.5, 0.3, 0}};
  ObjectState cup{"cup", {}, {0.04, 0.04, 0.05}, {0.1, 0, 0.05}, 0, Box{{-0.025, -0.025, -0.04}, {0.025, 0.025, 0.05}}};
  world.objects = {cup, {"knife", {}, {0.1, 0.012, 0.005}, {-0.2, 0, 0.005}, 0}};
  KinematicBody body(world);
  body.command(move(Capability::put, "knife", Relation::in, "cup"));
  const WorldReport report = until_rest(body, SimTime{1});
  CHECK(words_of(report.acts.back().reason) == "knife stands on its end");
  CHECK(place(body, "knife").isApprox(Vec3(0.1, 0, 0.11)));
  const Vec3 blade = report.poses.at(0).bodies.at("knife").R_WB * Vec3::UnitX();
  CHECK(blade.isApprox(Vec3(0, 0, -1), 1e-9));

  AvatarCommand away = command(Capability::put, "cup");
  away.goal.p_WG = {-0.3, 0.1, 0};
  CHECK(act(body, away).status == Status::done);
  CHECK(place(body, "knife").isApprox(Vec3(-0.3, 0.1, 0.11)));

  AvatarCommand lift = command(Capability::lift, "knife");
  lift.height_m = 0.3;
  act(body, lift);
  CHECK(act(body, command(Capability::ungrasp, "")).status == Status::done);
  CHECK(place(body, "knife").isApprox(Vec3(-0.3, 0.1, 0.11)));

  AvatarCommand out = command(Capability::put, "knife");
  out.goal.p_WG = {0.2, 0, 0};
  body.command(out);
  const WorldReport told = until_rest(body, SimTime{9});
  CHECK(told.acts.back().reason.empty());
  CHECK(place(body, "knife").isApprox(Vec3(0.2, 0, 0.005)));
  CHECK(told.poses.at(0).bodies.at("knife").R_WB.isApprox(Eigen::Quaterniond::Identity()));
}

TEST_CASE("a put is a grasp, a move and an ungrasp") {
  KinematicBody body(three_blocks()), at_once(three_blocks());
  AvatarCommand grasp = command(Capability::grasp, "b");
  grasp.next = move(Capability::move, "b", Relation::on, "a").goal;
  CHECK(act(body, grasp).status == Status::done);
  CHECK(act(body, grasp).status == Status::done);
  CHECK(place(body, "b").isApprox(Vec3(0.2, 0, 0.03)));
  CHECK(act(body, move(Capability::move, "", Relation::on, "a")).status == Status::done);
  CHECK(body.snapshot().held == "b");
  CHECK(act(body, command(Capability::ungrasp, "")).status == Status::done);
  CHECK(body.snapshot().held.empty());
  act(at_once, move(Capability::put, "b", Relation::on, "a"));
  for (const char* name : {"a", "b", "c"}) CHECK(place(body, name) == place(at_once, name));

  // A grasp is not begun for a goal that then cannot be reached.
  grasp.next = move(Capability::move, "b", Relation::on, "b").goal;
  CHECK(act(body, grasp).status == Status::blocked);
  grasp.next = move(Capability::move, "b", Relation::on, "d").goal;
  CHECK(act(body, grasp).status == Status::unreachable);
  CHECK(body.snapshot().held.empty());
  CHECK(words_of(act(body, move(Capability::move, "b", Relation::on, "a")).reason) == "b is not in the hand");
}

TEST_CASE("what is slid or moved while held stays held") {
  KinematicBody body(three_blocks());
  CHECK(act(body, move(Capability::slide, "a", Relation::left, "b")).status == Status::done);
  CHECK(body.snapshot().held.empty());
  act(body, command(Capability::grasp, "a"));
  CHECK(act(body, move(Capability::slide, "a", Relation::right, "b")).status == Status::done);
  CHECK(body.snapshot().held == "a");
}

TEST_CASE("a stop leaves undone what was told before it") {
  KinematicBody body(three_blocks());
  body.command(command(Capability::grasp, "c"));
  until_rest(body, SimTime{1});
  body.command(move(Capability::move, "c", Relation::on, "a"));
  body.command(command(Capability::look, "a"));
  body.command(command(Capability::stop, ""));
  body.command(command(Capability::reach, "a"));
  const WorldReport report = body.advance(SimTime{2});
  std::string told;
  for (const auto& one : report.acts) told += name_of(one.status) + " ";
  CHECK(told == "stopped started done started done started done ");
  CHECK(body.snapshot().held == "c");
  CHECK(place(body, "c").isApprox(Vec3(0.2, 0.01, 0.09)));
  CHECK(body.at_rest());
}

TEST_CASE("acts that cannot be done leave the world as it was") {
  KinematicBody body(three_blocks());
  CHECK(act(body, command(Capability::reach, "d")).status == Status::unreachable);
  CHECK(act(body, move(Capability::put, "a", Relation::on, "d")).status == Status::unreachable);
  CHECK(act(body, move(Capability::put, "a", Relation::on, "a")).status == Status::blocked);
  CHECK(words_of(act(body, move(Capability::put, "b", Relation::left, "c")).reason) ==
        "c stands on or in b, and would move along");
  CHECK(act(body, command(Capability::lift, "")).status == Status::blocked);
  act(body, command(Capability::grasp, "c"));
  CHECK(act(body, move(Capability::put, "a", Relation::under, "b")).status == Status::blocked);
  CHECK(body.snapshot().held == "c");
  act(body, command(Capability::ungrasp, ""));
  CHECK(act(body, command(Capability::signal, "")).status == Status::done);
  CHECK(place(body, "a").isApprox(Vec3(0, 0, 0.03)));
  CHECK(body.snapshot().held.empty());
}

TEST_CASE("capabilities and statuses have the names of the log") {
  CHECK(name_of(Capability::ungrasp) == "ungrasp");
  CHECK(name_of(Capability::move) == "move");
  CHECK(name_of(Status::unreachable) == "unreachable");
  CHECK(name_of(Status::stopped) == "stopped");
}

TEST_CASE("nothing is put beside the table or pushed off it") {
  KinematicBody body(three_blocks());
  const auto put_at = [&](const std::string& object, double x, double y) {
    AvatarCommand put = command(Capability::put, object);
    put.goal.p_WG = {x, y, 0};
    return words_of(act(body, put).reason);
  };
  CHECK(put_at("c", 0.51, 0) == "c would fall off the table");
  CHECK(put_at("c", 3, 2) == "c would fall off the table");
  CHECK(place(body, "c").isApprox(Vec3(0.2, 0.01, 0.09)));
  CHECK(put_at("c", 0.48, 0).empty());
  // Both find room at the edge.
  CHECK(put_at("a", 0.45, 0.01).empty());
  CHECK(place(body, "a").isApprox(Vec3(0.435, 0.01, 0.03)));
  CHECK(place(body, "c").isApprox(Vec3(0.495, 0, 0.03)));
}

namespace {

// An arm that gets no farther than to x = 0.1.
class ShortArm : public Ability {
 public:
  std::optional<Reason> hindrance(const AvatarCommand& command, const WorldSnapshot& world) const override {
    if (world.find(command.object)->p_WO.x() > 0.1) return Reason{ReasonCode::out_of_reach, {command.object}};
    if (!command.goal.relation && command.goal.p_WG.x() > 0.1) return Reason{ReasonCode::place_out_of_reach};
    return std::nullopt;
  }
  bool reaches(const Vec3& p_W) const override { return p_W.x() <= 0.1; }
};

}  // namespace

TEST_CASE("the arm's ability decides, and what it cannot do changes nothing") {
  KinematicBody body(three_blocks(), Occupied::avoided, std::make_shared<ShortArm>());
  act(body, command(Capability::grasp, "a"));
  const ActReport far = act(body, command(Capability::grasp, "b"));
  CHECK(far.status == Status::unreachable);
  CHECK(words_of(far.reason) == "b is out of my reach");
  CHECK(body.snapshot().held == "a");
  AvatarCommand grasp = command(Capability::grasp, "a");
  grasp.next = Goal{{}, {}, Perspective::avatar, Vec3(0.3, 0, 0)};
  act(body, command(Capability::ungrasp, ""));
  CHECK(words_of(act(body, grasp).reason) == "that place is out of my reach");
  CHECK(body.snapshot().held.empty());
  grasp.next->p_WG.x() = -0.3;
  CHECK(act(body, grasp).status == Status::done);
}
