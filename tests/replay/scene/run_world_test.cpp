#include "continua/replay/scene/run_world.h"

#include <filesystem>

#include "continua/replay/inspector/inspector_api.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"

using namespace continua;

namespace {

Json at(double x, double y, double z) { return {x, y, z, 1, 0, 0, 0}; }

// A scene of a table, two blocks and a hand.
Json header() {
  const Json geom{{"body", "red"},        {"type", "box"},    {"size", {0.1, 0.1, 0.1}},
                  {"rgba", {1, 0, 0, 1}}, {"pos", {0, 0, 0}}, {"quat", {1, 0, 0, 0}}};
  return {{"version", 1},
          {"scene",
           {{"geoms", {geom}},
            {"bodies",
             {{"table", at(0, 0, 0)}, {"red", at(0.1, 0, 0.1)}, {"blue", at(0.2, 0, 0.1)}, {"hand", at(0, 1, 1)}}}}}};
}

Json pointing(double x, const char* hand = "right") {
  return {{"line", 2}, {"event", {{"kind", "pointing"}, {"hand", hand}, {"target", {x, 0.5}}}}};
}

struct World {
  explicit World(const std::string& text) {
    auto index = RunIndex::of_text(text, "world.run.jsonl");
    if (!index) FAIL(index.error().text());
    run = std::make_shared<const RunIndex>(*std::move(index));
    auto read = RunWorld::read(run);
    if (!read) FAIL(read.error().text());
    world = *read;
  }
  Json window(double from, double to) const {
    return world->window(SimTime::from_seconds(from), SimTime::from_seconds(to));
  }
  std::shared_ptr<const RunIndex> run;
  std::shared_ptr<RunWorld> world;
};

Json column(const Json& list, const char* key) {
  Json values = Json::array();
  for (const auto& one : list) values.push_back(one[key]);
  return values;
}

}  // namespace

TEST_CASE("bodies are where they were logged last, and move as they were logged") {
  LogBuilder log;
  log.add("run", 0, header());
  log.add("pose", 1, {{"bodies", {{"red", at(1, 0, 0)}, {"lamp", at(5, 5, 5)}}}});
  log.add("pose", 2, {{"bodies", {{"blue", at(2, 0, 0)}}}});
  log.add("pose", 2, {{"bodies", {{"red", at(3, 0, 0)}, {"blue", at(4, 0, 0)}}}});
  log.add("pose", 3, {{"bodies", {{"red", at(6, 0, 0)}}}});
  log.add("end", 4);
  const World world(log.text());

  const auto all = world.window(0, 4);
  CHECK(all["start"]["red"] == at(0.1, 0, 0.1));
  CHECK(all["start"].size() == 4);
  CHECK(all["changes"] == Json{{1.0, {{"lamp", at(5, 5, 5)}, {"red", at(1, 0, 0)}}},
                               {2.0, {{"blue", at(4, 0, 0)}, {"red", at(3, 0, 0)}}},
                               {3.0, {{"red", at(6, 0, 0)}}}});
  CHECK_FALSE(all.contains("next"));

  const auto part = world.window(1, 2.5);
  CHECK(part["start"]["red"] == at(1, 0, 0));
  CHECK(part["start"]["lamp"] == at(5, 5, 5));
  CHECK(part["start"]["blue"] == at(0.2, 0, 0.1));
  CHECK(part["changes"].size() == 1);
  CHECK(world.window(4, 4)["start"]["red"] == at(6, 0, 0));
}

TEST_CASE("a long motion is told in windows that go on where the last one ended") {
  constexpr int count = 12000;
  LogBuilder log;
  log.add("run", 0, header());
  for (int i = 1; i <= count; ++i)
    log.add("pose", i * 0.03, {{"bodies", {{i % 3 == 0 ? "blue" : "red", at(i, 0, 0)}}}});
  log.add("end", 400);
  const World world(log.text());
  int seen = 0, windows = 0;
  Json poses = world.window(0, 0)["start"];
  for (double from = 0;; ++windows) {
    const auto window = world.window(from, 400);
    CHECK(window["start"] == poses);
    REQUIRE(window["changes"].size() <= 5000);
    for (const auto& change : window["changes"]) {
      for (const auto& [name, pose] : change[1].items()) {
        poses[name] = pose;
        CHECK(pose[0] == ++seen);
      }
    }
    if (!window.contains("next")) break;
    CHECK(window["to"] == window["next"]);
    from = window["next"];
  }
  CHECK(seen == count);
  CHECK(windows == 2);
  // In any order, and from any keyframe.
  for (const int i : {11999, 1, 257, 6000, 255, 256, 12000, 512})
    CHECK(world.window(i * 0.03, i * 0.03)["start"][i % 3 == 0 ? "blue" : "red"][0] == i);
}

TEST_CASE("the scene is the log's, as far as it can be drawn") {
  auto with = header();
  auto& geoms = with["scene"]["geoms"];
  const Json mesh{{"vertices", {0, 0, 0, 1, 0, 0, 0, 1, 0}}, {"faces", {0, 1, 2}}};
  geoms.push_back({{"body", "blue"}, {"type", "mesh"}, {"size", {1, 1, 1}}, {"mesh", mesh}});
  for (const Json& broken :
       {Json{{"vertices", {0, 0, 0}}, {"faces", {0, 1, 2}}}, Json{{"vertices", {0, 0}}, {"faces", Json::array()}},
        Json{{"vertices", {"x", 0, 0}}, {"faces", {0, 0, 0}}}, Json(3),
        Json{{"vertices", {0, 0, 0}}, {"faces", {0, 0, -1}}}})
    geoms.push_back({{"body", "blue"}, {"type", "mesh"}, {"size", {1, 1, 1}}, {"mesh", broken}});
  geoms.push_back({{"body", 3}, {"type", "box"}, {"size", {1, 1, 1}}});
  geoms.push_back({{"body", "red"}, {"type", "box"}, {"size", "large"}});
  geoms.push_back("geom");
  with["scene"]["bodies"]["ghost"] = {1, 2, 3};
  with["scene"]["bodies"]["turned"] = {0, 0, 0, 2, 0, 0, 0};
  with["scene"]["bodies"]["nowhere"] = {0, 0, 0, 0, 0, 0, 0};
  LogBuilder log;
  log.add("run", 0, with);
  const World world(log.text());
  const auto scene = *run_scene(*world.run);
  REQUIRE(scene["geoms"].size() == 7);
  CHECK(scene["geoms"][0] == header()["scene"]["geoms"][0]);
  CHECK(scene["geoms"][1]["mesh"] == mesh);
  CHECK(scene["geoms"][1]["quat"] == Json{1, 0, 0, 0});
  for (std::size_t i = 2; i < 7; ++i) CHECK_FALSE(scene["geoms"][i].contains("mesh"));
  CHECK(scene["bodies"].size() == 5);
  CHECK(scene["bodies"]["turned"] == at(0, 0, 0));
}

TEST_CASE("who points where, and from where") {
  LogBuilder log;
  log.add("run", 0, header());
  const auto first = log.add("input", 1, pointing(0.1));
  log.add("input", 1.4, pointing(0.2));
  log.add("input", 1.5, pointing(0.7, "left"));
  log.add("input", 5,
          {{"event",
            {{"kind", "gesture"},
             {"name", "point"},
             {"phase", "start"},
             {"hand", "right"},
             {"ray", {{"from", {0, 0, 1}}, {"direction", {0.5, 0, -1}}}}}}});
  log.add("input", 7, {{"event", {{"kind", "gesture"}, {"name", "point"}, {"phase", "stop"}, {"hand", "right"}}}});
  log.add("gesture", 8, {{"gesture", "point(blue)"}});
  log.add("gesture", 9, {{"gesture", "point(arm, <0.3, 0.4, 0>)"}});
  log.add("gesture", 9.5, {{"gesture", "nod"}});
  log.add("end", 20);
  const World world(log.text());
  const auto all = world.window(0, 20)["pointing"];
  REQUIRE(all.size() == 5);
  CHECK(all[0]["who"] == "human");
  CHECK(all[0]["hand"] == "right");
  CHECK(all[0]["n"] == first);
  CHECK(all[0]["samples"] == Json{{1.0, 0.1, 0.5, 0.0}, {1.4, 0.2, 0.5, 0.0}});
  CHECK(all[0]["origin"].is_null());
  CHECK(all[1]["hand"] == "left");
  CHECK(all[2]["samples"] == Json{{5.0, 0.5, 0.0, 0.0}});
  CHECK(all[2]["origin"] == Json{0.0, 0.0, 1.0});
  CHECK(all[2]["to"] == 7);
  CHECK(all[3]["who"] == "avatar");
  CHECK(all[3]["samples"] == Json{{8.0, 0.2, 0.0, 0.1}});
  CHECK(all[3]["to"] == 9);
  CHECK(all[4]["samples"] == Json{{9.0, 0.3, 0.4, 0.0}});
  // The last pose before a window counts in it.
  const auto part = world.window(1.2, 1.3)["pointing"];
  REQUIRE(part.size() == 1);
  CHECK(part[0]["samples"] == Json{{1.0, 0.1, 0.5, 0.0}});
  CHECK(world.window(12, 20)["pointing"].empty());
}

TEST_CASE("acts tell what they are done with and whither") {
  struct Row {
    const char* program;
    std::vector<std::pair<const char*, const char*>> steps;  // program, status
    const char* status;
    Json object, target;
  };
  const Json at_blue{0.2, 0.0, 0.1}, moved{9.0, 0.0, 0.0}, place{0.5, -0.1, 0.0};
  const std::vector<Row> rows{
      {"put(red, <0.5, -0.1, 0>)",
       {{"grasp(red)", "done"}, {"move(red, <0.1, 0.1, 0>)", "done"}},
       "done",
       "red",
       place},
      {"put(red, on(blue))", {}, "stopped", "red", at_blue},
      {"put(red, on(blue))", {}, "done", "red", moved},
      {"put(red, was(red))", {{"move(red, <0.5, -0.1, 0>)", "started"}}, "started", "red", place},
      {"put(red, on(blue))",
       {{"move(blue, <3, 3, 0>)", "done"}, {"move(red, <0.5, -0.1, 0>)", "done"}},
       "done",
       "red",
       place},
      {"lift(red)", {{"grasp(red)", "done"}}, "done", "red", nullptr},
      {"stop", {}, "done", nullptr, nullptr},
      {"clear", {{"move(blue, <0.5, -0.1, 0>)", "done"}}, "done", "blue", place},
      {"put(green, on(yellow))", {}, "done", nullptr, nullptr},
      {"put(red, <1, x>", {}, "done", nullptr, nullptr},
      {")(", {}, "done", nullptr, nullptr},
  };
  for (const auto& row : rows) {
    LogBuilder log;
    log.add("run", 0, header());
    const auto asked = log.add("act", 1, {{"act", 1}, {"program", row.program}, {"status", "asked"}});
    log.add("act", 2, {{"act", 1}, {"program", row.program}, {"status", "started"}});
    int step = 0;
    for (const auto& [program, status] : row.steps)
      log.add("act", 3, {{"act", 1}, {"program", program}, {"status", status}, {"step", ++step}});
    log.add("pose", 3.5, {{"bodies", {{"red", at(9, 0, 0)}}}});
    if (std::string(row.status) != "started")
      log.add("act", 4, {{"act", 1}, {"program", row.program}, {"status", row.status}});
    log.add("end", 10);
    const auto acts = World(log.text()).window(0, 10)["acts"];
    INFO(row.program << ": " << acts);
    REQUIRE(acts.size() == 1);
    CHECK(acts[0]["n"] == asked);
    CHECK(acts[0]["program"] == row.program);
    CHECK(acts[0]["status"] == row.status);
    CHECK(acts[0]["from"] == 2);
    CHECK(acts[0]["to"] == (std::string(row.status) == "started" ? 10 : 4));
    CHECK(acts[0]["object"] == row.object);
    CHECK(acts[0]["target"] == row.target);
  }
}

TEST_CASE("windows with more samples or acts than fit are told in parts") {
  LogBuilder log;
  log.add("run", 0, header());
  for (int i = 0; i < 11000; ++i) log.add("input", i * 0.1, pointing(i));
  for (int i = 0; i < 6000; ++i)
    for (const char* status : {"started", "done"})
      log.add("act", 1100 + i * 0.1, {{"act", i}, {"program", "wait"}, {"status", status}});
  const World world(log.text());
  double from = 0;
  std::size_t samples = 0, acts = 0, windows = 0;
  for (;; ++windows) {
    const auto window = world.window(from, 2000);
    for (const auto& one : window["pointing"])
      for (const auto& sample : one["samples"]) samples += sample[0] > from || (from == 0 && sample[0] == 0);
    for (const auto& act : window["acts"]) acts += act["from"] > from;
    REQUIRE(window["acts"].size() <= 5000);
    if (!window.contains("next")) break;
    REQUIRE(window["next"] > from);
    from = window["next"];
  }
  CHECK(samples == 11000);
  CHECK(acts == 6000);
  CHECK(windows == 3);
}

TEST_CASE("logs of any form give a world or a sentence") {
  const std::vector<Json> oddities{Json(),
                                   Json(3),
                                   Json("x"),
                                   Json::array({1, "a", nullptr}),
                                   Json::object(),
                                   Json{{"red", 3}},
                                   Json{{"red", {1, 2, 3, 4, 5, 6}}},
                                   Json{{"red", {0, 0, 0, 1e200, 1e200, 0, 0}}}};
  for (const auto& odd : oddities) {
    LogBuilder log;
    auto first = header();
    log.add("run", 0, first);
    log.add("pose", 1, {{"bodies", odd}});
    log.add("pose", 0.5, {{"bodies", {{"red", at(7, 0, 0)}}}});  // before the last one
    log.add("pose", 1);
    for (const char* key : {"kind", "target", "hand", "ray", "phase", "name", "until"}) {
      Json event{{"kind", "gesture"}, {"name", "point"}, {"target", {0.1, 0.2}}};
      event[key] = odd;
      log.add("input", 2, {{"event", event}});
      event["kind"] = "pointing";
      log.add("input", 2, {{"event", event}});
    }
    log.add("input", 2, {{"event", odd}});
    log.add("input", 2);
    log.add("gesture", 2, {{"gesture", odd}});
    log.add("gesture", 2, {{"gesture", "point(<,>>(<"}});
    for (const char* key : {"act", "program", "status", "step"}) {
      Json act{{"act", 1}, {"program", "put(red, on(blue))"}, {"status", "done"}};
      act[key] = odd;
      log.add("act", 3, act);
    }
    const World world(log.text());
    INFO(odd);
    CHECK(world.window(1, 1)["start"]["red"] == at(7, 0, 0));
    CHECK(world.window(0, 1e9).contains("changes"));

    const ScratchFolder folder;
    folder.write("cut.run.jsonl", log.text().substr(0, log.text().size() - 20));
    auto scene = header();
    scene["scene"] = odd;
    LogBuilder without;
    without.add("run", 0, scene);
    folder.write("without.run.jsonl", without.text());
    scene = header();
    scene["scene"]["geoms"] = odd;
    scene["scene"]["bodies"] = odd;
    LogBuilder other;
    other.add("run", 0, scene);
    folder.write("other.run.jsonl", other.text());
    InspectorApi api({folder.path()});
    CHECK(api.get("/api/runs/cut/poses").status == 200);
    CHECK(api.get("/api/runs/without/scene").status == 422);
    CHECK(api.get("/api/runs/without/poses").status == 200);
    CHECK(api.get("/api/runs/other/scene").status == (odd.is_object() ? 200 : 422));
  }
}

TEST_CASE("windows that are none are refused") {
  const ScratchFolder folder;
  folder.write("small.run.jsonl", small_log().text());
  InspectorApi api({folder.path()});
  for (const char* bad : {"from=x", "from=-1", "to=nan", "from=5&to=4", "from=inf", "to=1e300", "from=11"}) {
    INFO(bad);
    CHECK(api.get(std::string("/api/runs/small/poses?") + bad).status == 400);
  }
  const auto window = Json::parse(api.get("/api/runs/small/poses").body);
  CHECK(window["to"] == 10);
  CHECK(column(window["acts"], "act") == Json{1});
}
