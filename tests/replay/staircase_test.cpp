// A staircase of six blocks, built by a human's words and gestures.
#include <filesystem>
#include <map>
#include <sstream>

#include "continua/replay/session/session.h"
#include "continua/simulation/physics.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;

TEST_CASE("a staircase of three steps is built by commands, and stands for ten seconds after the last") {
  const std::string source = source_dir();
  auto session = Session::load(source + "/traces/talk/staircase.trace.jsonl", {});
  if (!session) FAIL(session.error().text());
  std::stringstream log;
  const ReplaySummary summary = session->run(log);
  CHECK(summary.expectations_met == summary.expectations);
  CHECK(summary.acts_done == summary.acts);

  std::map<std::string, Vec3> places;
  double last_done_s = 0, last_moved_s = 0;
  for (std::string line; std::getline(log, line);) {
    const Json record = Json::parse(line);
    if (record["kind"] == "run") {
      for (const auto& [name, pose] : record["scene"]["bodies"].items())
        if (name.starts_with("block")) places[name] = Vec3(pose[0], pose[1], pose[2]);
    } else if (record["kind"] == "act" && !record.contains("step") && record["status"] == "done") {
      last_done_s = record["t"];
    } else if (record["kind"] == "pose") {
      for (const auto& [name, pose] : record["bodies"].items()) {
        if (!name.starts_with("block")) continue;
        places[name] = Vec3(pose[0], pose[1], pose[2]);
        last_moved_s = record["t"];
      }
    }
  }
  CHECK(last_moved_s < last_done_s);
  CHECK(summary.end.seconds() > last_done_s + 10);

  const Vec3 corner = places.at("block4");
  const std::map<std::string, std::pair<int, int>> steps = {{"block4", {0, 0}}, {"block1", {1, 0}}, {"block3", {1, 1}},
                                                            {"block6", {2, 0}}, {"block7", {2, 1}}, {"block5", {2, 2}}};
  std::vector<ObjectOverride> standing;
  for (const auto& [name, step] : steps) {
    CAPTURE(name);
    const Vec3& p = places.at(name);
    CHECK(p.x() - corner.x() == Approx(0.06 * step.first).margin(0.005));
    CHECK(p.y() - corner.y() == Approx(0).margin(0.005));
    CHECK(p.z() == Approx(0.03 + 0.06 * step.second).margin(0.001));
    standing.push_back({name, p.x(), p.y(), p.z(), {}, false});
  }

  // Nor does it creep when the world is not taken to be at rest.
  const Scene scene = load_scene(source + "/mjcf/scenes/staircase.xml", standing).value();
  auto physics = Physics::create(scene).value();
  const AvatarTarget home{{physics->arm().home, ArmVector::Zero(physics->arm().size())}, 0.02};
  for (int i = 0; i < 5000; ++i) REQUIRE(physics->step(home));
  for (std::size_t i = 0; i < scene.objects().size(); ++i)
    CHECK((physics->object_pose(static_cast<int>(i)).p_WB - places.at(scene.objects()[i].name)).norm() < 1e-3);
}
