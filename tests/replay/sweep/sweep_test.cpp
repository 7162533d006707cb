// Grids of points, their tables and pictures, and the command, whole and in shards.
#include "continua/replay/commands/sweep.h"

#include <filesystem>

#include "continua/replay/sweep/sweep_axes.h"
#include "continua/replay/sweep/sweep_grid.h"
#include "continua/replay/sweep/sweep_pictures.h"
#include "support/catch.h"
#include "support/standard_output.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

std::string points_of(const std::string& grid) {
  const auto points = read_sweep_grid(grid, "g.json");
  if (!points) return points.error().text();
  std::string text;
  for (const auto& point : *points) text += compact(point.json()) + "\n";
  return text;
}

SweptPoint point(std::size_t number, Json set, const std::string& seed, double f1) {
  return {number, std::move(set), "", seed, {{"f1", f1}}};
}

const std::string talk = R"json({"kind":"trace","version":1,"scene":"place_setting","machine":"interaction"}
{"t":1,"kind":"speech","text":"Put the knife on the plate."}
{"t":1.5,"kind":"observed","channel":"speech","content":"Okay."}
{"t":4,"kind":"end"}
)json";

SweepOptions options_of(const TemporaryFolder& folder, const std::string& output) {
  SweepOptions options;
  options.grid = folder.at("grid.json");
  options.traces = {folder.at("talk.trace.jsonl")};
  options.output = folder.at(output);
  options.replay.physics = false;
  return options;
}

std::string file(const TemporaryFolder& folder, const std::string& name) { return read_file(folder.at(name)).value(); }

}  // namespace

TEST_CASE("a grid names each of one part with each of the others") {
  CHECK(points_of("{}") == "{\"set\":{}}\n");
  CHECK(points_of(R"({"grid": {"a": [1, true], "b": {"from": 0.1, "to": 0.3, "count": 3}}})") ==
        R"({"set":{"a":1,"b":0.1}}
{"set":{"a":1,"b":0.2}}
{"set":{"a":1,"b":0.3}}
{"set":{"a":true,"b":0.1}}
{"set":{"a":true,"b":0.2}}
{"set":{"a":true,"b":0.3}}
)");
  CHECK(points_of(R"({"list": [{"a": "x"}, {}], "policies": ["sample"], "seeds": {"from": 3, "to": 4}})") ==
        R"({"set":{"a":"x"},"policy":"sample","seed":3}
{"set":{"a":"x"},"policy":"sample","seed":4}
{"set":{},"policy":"sample","seed":3}
{"set":{},"policy":"sample","seed":4}
)");
}

TEST_CASE("a Latin hypercube has the middle of each part of each range once") {
  const auto points = read_sweep_grid(R"({"latin": {"count": 5, "seed": 7, "of": {"a": [0, 1], "b": [10, 20]}}})", "");
  REQUIRE(points.ok());
  std::set<double> a, b;
  for (const auto& point : *points) {
    a.insert(point.set["a"].get<double>());
    b.insert(point.set["b"].get<double>());
  }
  CHECK(a == std::set<double>{0.1, 0.3, 0.5, 0.7, 0.9});
  CHECK(b == std::set<double>{11, 13, 15, 17, 19});
}

TEST_CASE("a wrong grid is told with its place") {
  CHECK(points_of("{\n\"grids\": {}}") ==
        "g.json:2:10: there is no part 'grids'; expected list, latin, grid, policies or seeds");
  CHECK_THAT(points_of(R"({"grid": {"a": 3}})"), Catch::Contains("g.json:1:16: found '3'; expected [VALUE, …]"));
  CHECK_THAT(points_of(R"({"grid": {"a": [1]}, "list": [{"a": 2}]})"), Catch::Contains("sets 'a' in two parts"));
  CHECK_THAT(points_of(R"({"grid": {"a": [1], "a": [2]}})"), Catch::Contains("has 'a' twice"));
  CHECK_THAT(points_of(R"({"latin": {"count": 0, "of": {"a": [0, 1]}}})"), Catch::Contains("expected {\"count\": 1"));
  CHECK_THAT(points_of(R"({"seeds": {"from": 4, "to": 3}})"), Catch::Contains("expected [SEED, …]"));
  CHECK_THAT(
      points_of(R"({"grid": {"a": {"from": 0, "to": 1, "count": 9999}, "b": {"from": 0, "to": 1, "count": 9999}}})"),
      Catch::Contains("names over 1000000 points"));
}

TEST_CASE("means are over all other values, their interval over seeds") {
  const std::vector<SweptPoint> points = {
      point(1, {{"a", 2}, {"b", "x"}}, "1", 0.2), point(2, {{"a", 2}, {"b", "y"}}, "1", 0.4),
      point(3, {{"a", 2}, {"b", "x"}}, "2", 0.4), point(4, {{"a", 1}, {"b", "x"}}, "1", 0.9)};
  const auto axes = axes_of(points);
  REQUIRE(axes.size() == 2);
  CHECK(axes[0].levels == std::vector<std::string>{"1", "2"});
  CHECK(axes[1].levels == std::vector<std::string>{"x", "y"});
  const auto two = mean_at(points, "f1", axes[0], 1);
  CHECK(two.points == 3);
  CHECK(two.mean == Approx(0.35));  // of the seeds' means 0.3 and 0.4
  CHECK(two.high - two.mean == Approx(12.706 * 0.05));
  CHECK(mean_at(points, "f1", axes[0], 1, axes[1], 0).mean == Approx(0.3));
  CHECK(mean_at(points, "f1", axes[0], 0, axes[1], 1).points == 0);
  const auto heat = heat_maps(points, "f1");
  CHECK_THAT(heat, Catch::Contains("<title>a = 2, b = x: 0.3 (2 points)</title>"));
  CHECK_THAT(curves(points, "f1"), Catch::Contains("95 % interval of the mean over seeds"));
  CHECK(heat_maps({points[0], points[3]}, "f1").empty());
}

TEST_CASE("the curve of one value has room for the line about it") {
  const auto svg = curves({point(1, {{"a", 1}}, "1", 0.4), point(2, {{"a", 2}}, "2", 0.6)}, "f1");
  const std::string about = "class=\"quiet\"", width = " width=\"";
  const auto from = svg.find('>', svg.find(about)) + 1;
  const auto letters = svg.find('<', from) - from;
  REQUIRE(letters > 60);
  CHECK(std::stod(svg.substr(svg.find(width) + width.size())) > 6 * static_cast<double>(letters));
}

TEST_CASE("a heat map has the names of its rows whole, with room for them") {
  std::vector<SweptPoint> points;
  const std::string name = "weights.a_transition_with_a_long_name";
  for (std::size_t i = 0; i < 4; ++i) points.push_back(point(i + 1, {{"a", i % 2}, {name, i / 2}}, "1", 0.5));
  const auto heat = heat_maps(points, "f1");
  const std::string begin = "<text class=\"name right\" x=\"";
  const auto at = heat.find(begin);
  REQUIRE(at != std::string::npos);
  CHECK(heat.find(">" + name + "</text>", at) != std::string::npos);
  CHECK(std::stod(heat.substr(at + begin.size())) > 7 * static_cast<double>(name.size()));
}

TEST_CASE("many numbers of an axis are put into equal parts of their range") {
  std::vector<SweptPoint> points;
  for (std::size_t i = 0; i < 24; ++i) points.push_back(point(i + 1, {{"a", static_cast<double>(i) / 2}}, "", 0.5));
  const auto axes = axes_of(points);
  REQUIRE(axes.size() == 1);
  CHECK(axes[0].levels.size() == most_levels);
  CHECK(axes[0].level_of.front() == 0u);
  CHECK(axes[0].level_of.back() == most_levels - 1);
}

TEST_CASE("a sweep goes on where it was, and its shards tell together what one process tells") {
  const TemporaryFolder folder;
  folder.file("talk.trace.jsonl", talk);
  folder.file("grid.json", R"({"grid": {"surer_by": [0.1, 0.3]}, "seeds": [1, 2], "policies": ["sample"]})");
  const auto [status, table] = told([&] { return run_sweep(options_of(folder, "whole")); });
  CHECK(status == exit_done);
  CHECK(std::count(table.begin(), table.end(), '\n') == 5);
  const auto lines = file(folder, "whole/points.jsonl");
  CHECK(std::count(lines.begin(), lines.end(), '\n') == 4);

  // The point that is gone is done again, and nothing else.
  const auto first = fs::directory_iterator(folder.at("whole/points"))->path();
  const auto content = read_file(first.string()).value();
  fs::remove(first);
  std::map<std::string, fs::file_time_type> before;
  for (const auto& entry : fs::directory_iterator(folder.at("whole/points")))
    before[entry.path().string()] = entry.last_write_time();
  CHECK(told([&] { return run_sweep(options_of(folder, "whole")); }).second == table);
  CHECK(read_file(first.string()).value() == content);
  for (const auto& [path, time] : before) CHECK(fs::last_write_time(path) == time);

  for (const std::size_t count : {1, 2, 7}) {
    const auto name = "sharded" + std::to_string(count);
    std::vector<std::string> reports;
    for (std::size_t index = 1; index <= count; ++index) {
      auto options = options_of(folder, name);
      options.shards.shard = {index, count};
      options.shards.report = folder.at(std::to_string(index) + ".json");
      CHECK(told([&] { return run_sweep(options); }).first == exit_done);
      reports.push_back(options.shards.report);
    }
    auto options = options_of(folder, name);
    options.shards.merge = reports;
    CHECK(told([&] { return run_sweep(options); }) == std::pair(int{exit_done}, table));
    for (const auto* each : {"/points.jsonl", "/points.csv", "/curves.svg"})
      CHECK(file(folder, name + each) == file(folder, std::string("whole") + each));
  }
}

TEST_CASE("a point that its machine does not have is left out, and told") {
  const TemporaryFolder folder;
  folder.file("talk.trace.jsonl", talk);
  folder.file("grid.json", R"({"list": [{"surer_by": 0.1}, {"no_such": 1}]})");
  const auto [status, table] = told([&] { return run_sweep(options_of(folder, "out")); });
  CHECK(status == exit_impossible);
  CHECK(std::count(table.begin(), table.end(), '\n') == 2);
}
