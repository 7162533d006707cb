#include "continua/replay/terminal/shard.h"

#include <map>

#include "support/catch.h"

using namespace continua;

namespace {

std::string parsed(const std::string& text, const std::map<std::string, std::string>& environment = {}) {
  const auto shard = parse_shard(text, [&](const char* name) {
    const auto found = environment.find(name);
    return found == environment.end() ? nullptr : found->second.c_str();
  });
  return shard ? std::to_string(shard->index) + " of " + std::to_string(shard->count) : shard.error().sentence;
}

ShardReport report_of(std::size_t index, std::size_t count, std::size_t items) {
  ShardReport report{"replay", {index, count}, items, 0, {}};
  for (std::size_t item = 0; item < items; ++item)
    if (report.shard.has(item)) report.told.push_back(std::to_string(item) + "\n");
  return report;
}

}  // namespace

TEST_CASE("a shard is told by hand, or by what a task's environment says") {
  CHECK(parsed("1/1") == "1 of 1");
  CHECK(parsed("2/7") == "2 of 7");
  for (const char* wrong :
       {"0/4", "5/4", "", "1", "1/", "/1", "1/2x", "-1/2", "1/99999999999999999999999", "a/b", "1/2/3"})
    CHECK(parsed(wrong) == "found '" + std::string(wrong) + "'; expected I/N, I from 1 to N, or auto");
  CHECK(parsed("auto", {{"SLURM_ARRAY_TASK_ID", "3"}, {"SLURM_ARRAY_TASK_COUNT", "8"}}) == "3 of 8");
  CHECK(
      parsed("auto", {{"SLURM_ARRAY_TASK_ID", "10"}, {"SLURM_ARRAY_TASK_COUNT", "2"}, {"SLURM_ARRAY_TASK_MIN", "9"}}) ==
      "2 of 2");
  CHECK(parsed("auto", {{"CI_NODE_INDEX", "2"}, {"CI_NODE_TOTAL", "3"}}) == "2 of 3");
  CHECK(parsed("auto", {{"CIRCLE_NODE_INDEX", "0"}, {"CIRCLE_NODE_TOTAL", "3"}}) == "1 of 3");
  CHECK_THAT(parsed("auto", {{"SLURM_ARRAY_TASK_ID", "9"}, {"SLURM_ARRAY_TASK_COUNT", "2"}}),
             Catch::Contains("Slurm says that SLURM_ARRAY_TASK_ID is '9'"));
  CHECK_THAT(parsed("auto"), Catch::Contains("none of SLURM_ARRAY_TASK_ID and SLURM_ARRAY_TASK_COUNT, CI_NODE_INDEX"));
}

TEST_CASE("every item is in one shard, and the shards are of about equal size") {
  for (std::size_t count : {1, 2, 7, 64})
    for (std::size_t items : {0, 1, 6, 7, 1000}) {
      std::size_t all = 0;
      for (std::size_t index = 1; index <= count; ++index) {
        const Shard shard{index, count};
        std::size_t has = 0;
        for (std::size_t item = 0; item < items; ++item) has += shard.has(item);
        CHECK(has == shard.share(items));
        CHECK((has == items / count || has == items / count + 1));
        all += has;
      }
      CHECK(all == items);
    }
}

TEST_CASE("a shard's report is read back, or told where it is wrong") {
  const auto report = report_of(2, 3, 7);
  const auto again = read_shard_report(text_of(report), "r.json");
  REQUIRE(again.ok());
  CHECK(text_of(*again) == text_of(report));
  CHECK(again->told == std::vector<std::string>{"1\n", "4\n"});
  const auto error_with = [&](const std::string& from, const std::string& to) {
    auto text = text_of(report);
    text.replace(text.find(from), from.size(), to);
    const auto read = read_shard_report(text, "r.json");
    return read ? std::string() : read.error().text();
  };
  CHECK_THAT(error_with("\"shards\": 1", "\"shards\": 2"), Catch::Contains("found no report of a shard"));
  CHECK_THAT(error_with("\"items\": 7", "\"items\": 70"), Catch::Contains("expected 23 texts, the share of shard 2/3"));
  CHECK_THAT(error_with("\"status\": 0", "\"status\": 9"), Catch::Contains("expected 0, 1 or 2"));
  CHECK_THAT(error_with("\"replay\"", "3"), Catch::Contains("expected the name of a command"));
  CHECK_THAT(error_with("\"shards\"", "\"shards"), Catch::Contains("r.json:"));
}

TEST_CASE("reports find their shards, and what is missing or doubled is told") {
  const auto shards_of = [](const std::vector<ShardReport>& reports) {
    std::vector<ShardOf> shards;
    for (const auto& report : reports)
      shards.push_back({std::to_string(shards.size()) + ".json", report.shard, report.items});
    return shards;
  };
  const auto whole = places_of(shards_of({report_of(2, 2, 5), report_of(1, 2, 5)}), "trace");
  CHECK(whole.problems.empty());
  CHECK(whole.report_of == std::vector<std::optional<std::size_t>>{1, 0});
  const auto problem_of = [&](const std::vector<ShardReport>& reports) {
    return places_of(shards_of(reports), "trace").problems.front().text();
  };
  CHECK(problem_of({report_of(1, 2, 5)}) == "--merge: shard 2/2 is missing");
  CHECK(problem_of({report_of(1, 1, 5), report_of(1, 1, 5)}) ==
        "1.json: is shard 1/1, and so is 0.json; expected each once");
  CHECK(problem_of({report_of(1, 2, 5), report_of(2, 2, 6)}) ==
        "1.json: is shard 2/2 of 6 traces; expected one of 2 of 5 traces as in 0.json");
}
