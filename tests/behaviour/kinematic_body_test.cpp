#include "behaviour/kinematic_body.h"

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

AvatarCommand move(Capability what, const std::string& object, Goal::Relation relation, const std::string& landmark) {
  AvatarCommand command;
  command.what = what;
  command.object = object;
  command.goal.relation = relation;
  command.goal.landmark = landmark;
  return command;
}

ActReport act(KinematicBody& body, const AvatarCommand& command) {
  body.command(command);
  return body.advance(body.snapshot().t + SimTime{1}).acts.back();
}

Vec3 place(const KinematicBody& body, const std::string& name) { return body.snapshot().find(name)->p_WO; }

}  // namespace

TEST_CASE("goals touch their landmark, on the avatar's sides") {
  const WorldSnapshot world = three_blocks();
  const auto goal = [&](Goal::Relation relation) {
    return goal_position(move(Capability::put, "c", relation, "a"), world);
  };
  CHECK(goal(Goal::Relation::left_of).isApprox(Vec3(0.06, 0, 0.03)));
  CHECK(goal(Goal::Relation::right_of).isApprox(Vec3(-0.06, 0, 0.03)));
  CHECK(goal(Goal::Relation::in_front_of).isApprox(Vec3(0, 0.06, 0.03)));
  CHECK(goal(Goal::Relation::behind).isApprox(Vec3(0, -0.06, 0.03)));
  CHECK(goal(Goal::Relation::on).isApprox(Vec3(0, 0, 0.09)));
  // Beside something that stands on another thing there is only the table, unless that thing is wide enough.
  CHECK(goal_position(move(Capability::put, "a", Goal::Relation::left_of, "c"), world).z() == Approx(0.03));
  AvatarCommand at = command(Capability::put, "c");
  at.goal.p_WG = {0.12344, 0, 0.5};
  CHECK(goal_position(at, world).isApprox(Vec3(0.1234, 0, 0.03)));
}

TEST_CASE("acts are done at once, and what stands on an object moves along") {
  KinematicBody body(three_blocks());
  body.command(move(Capability::put, "b", Goal::Relation::on, "a"));
  CHECK_FALSE(body.at_rest());
  const WorldReport report = body.advance(SimTime{5});
  CHECK(body.at_rest());
  REQUIRE(report.acts.size() == 2);
  CHECK(report.acts[0].status == Status::started);
  CHECK(report.acts[1].status == Status::done);
  CHECK(report.acts[1].t == SimTime{5});
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

TEST_CASE("a put of another object lets go of the one in the hand") {
  KinematicBody body(three_blocks());
  AvatarCommand lift = command(Capability::lift, "c");
  lift.height_m = 0.1;
  act(body, lift);
  act(body, move(Capability::put, "a", Goal::Relation::on, "c"));
  CHECK(body.snapshot().held.empty());
  CHECK(place(body, "c").z() == Approx(0.09));
  CHECK(place(body, "a").z() == Approx(0.15));
}

TEST_CASE("acts that cannot be done leave the world as it was") {
  KinematicBody body(three_blocks());
  CHECK(act(body, command(Capability::reach, "d")).status == Status::unreachable);
  CHECK(act(body, move(Capability::put, "a", Goal::Relation::on, "d")).status == Status::unreachable);
  CHECK(act(body, move(Capability::put, "a", Goal::Relation::on, "a")).status == Status::blocked);
  CHECK(act(body, command(Capability::lift, "")).status == Status::blocked);
  CHECK(act(body, command(Capability::signal, "")).status == Status::done);
  CHECK(place(body, "a").isApprox(Vec3(0, 0, 0.03)));
  CHECK(body.snapshot().held.empty());
}

TEST_CASE("capabilities, statuses and relations have the names of the log") {
  CHECK(text(Capability::ungrasp) == "ungrasp");
  CHECK(text(Status::unreachable) == "unreachable");
  CHECK(text(Goal::Relation::in_front_of) == "in_front_of");
}
