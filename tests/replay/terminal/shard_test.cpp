#include "continua/replay/terminal/shard.h"

#include <algorithm>
#include <map>

#include "support/catch.h"
#include "support/temporary_folder.h"

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
  const Shard shard{index, count};
  ShardReport report{"replay", shard, items, dealt(shard, std::vector<std::uint64_t>(items, 1)), 0, {}};
  for (const auto item : report.numbers) report.told.push_back(std::to_string(item) + "\n");
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

TEST_CASE("every item is in one shard, and shards of equal items are of about equal size") {
  for (std::size_t count : {1, 2, 7, 64})
    for (std::size_t items : {0, 1, 6, 7, 1000})
      for (std::uint64_t cost : {0, 5}) {
        std::vector<int> times(items);
        for (std::size_t index = 1; index <= count; ++index) {
          const auto has = dealt({index, count}, std::vector<std::uint64_t>(items, cost));
          CHECK((has.size() == items / count || has.size() == items / count + 1));
          CHECK(std::is_sorted(has.begin(), has.end()));
          for (const auto item : has) ++times[item];
        }
        CHECK(std::all_of(times.begin(), times.end(), [](int one) { return one == 1; }));
      }
}

TEST_CASE("the dearest item is dealt first, each to the shard with the least so far") {
  const std::vector<std::uint64_t> costs{1, 9, 2, 3, 8, 3};
  // 9 | 8, then 3 and 2 to the second, 3 and 1 to the first.
  CHECK(dealt({1, 2}, costs) == std::vector<std::size_t>{0, 1, 5});
  CHECK(dealt({2, 2}, costs) == std::vector<std::size_t>{2, 3, 4});
}

TEST_CASE("the cost of work on files is that of their bytes") {
  TemporaryFolder folder;
  const auto one = folder.file("a", "12345");
  folder.file("in/b", "12");
  folder.file("in/c/d", "123");
  CHECK(costs_of({one, (folder.path() / "in").string(), (folder.path() / "none").string()}) ==
        std::vector<std::uint64_t>{5, 5, 0});
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
  CHECK_THAT(error_with("\"items\": 7", "\"items\": 1"), Catch::Contains("expected numbers from 1 to 1, ascending"));
  CHECK_THAT(error_with("\"items\": 7", "\"items\": 77777777777"), Catch::Contains("expected at most 10000000"));
  CHECK_THAT(error_with("5\n", "2\n"), Catch::Contains("found 2; expected numbers from 1 to 7, ascending"));
  CHECK_THAT(error_with("\"4\\n\"", "4"), Catch::Contains("expected a list of texts"));
  CHECK_THAT(error_with(",\n  \"4\\n\"", ""), Catch::Contains("found 1; expected 2 for shard 2/3 of 7 items"));
  CHECK_THAT(error_with("\"status\": 0", "\"status\": 9"), Catch::Contains("expected 0, 1 or 2"));
  CHECK_THAT(error_with("\"replay\"", "3"), Catch::Contains("expected the name of a command"));
  CHECK_THAT(error_with("\"shards\"", "\"shards"), Catch::Contains("r.json:"));
}

TEST_CASE("a report of an earlier version has no numbers: each N-th item was its own") {
  auto text = text_of(report_of(2, 3, 7));
  const auto from = text.find(" \"numbers\"");
  text.erase(from, text.find("],\n", from) + 3 - from);
  const auto old = read_shard_report(text, "r.json");
  if (!old) FAIL(old.error().text());
  CHECK(old->numbers == std::vector<std::size_t>{1, 4});
}

TEST_CASE("reports find their shards, and what is missing or doubled is told") {
  const auto shards_of = [](const std::vector<ShardReport>& reports) {
    std::vector<ShardOf> shards;
    for (const auto& report : reports)
      shards.push_back({std::to_string(shards.size()) + ".json", report.shard, report.items, report.numbers});
    return shards;
  };
  const auto whole = places_of(shards_of({report_of(2, 2, 5), report_of(1, 2, 5)}), "trace");
  CHECK(whole.problems.empty());
  CHECK(whole.reports == std::vector<std::size_t>{1, 0});
  REQUIRE(whole.items.size() == 5);
  CHECK(whole.items[2]->report == 1);
  CHECK(whole.items[2]->among_its == 1);
  const auto problem_of = [&](const std::vector<ShardReport>& reports) {
    return places_of(shards_of(reports), "trace").problems.front().text();
  };
  CHECK(problem_of({report_of(1, 2, 5)}) == "--merge: shard 2/2 is missing");
  CHECK(problem_of({report_of(1, 1, 5), report_of(1, 1, 5)}) ==
        "1.json: is shard 1/1, and so is 0.json; expected each once");
  CHECK(problem_of({report_of(1, 2, 5), report_of(2, 2, 6)}) ==
        "1.json: is shard 2/2 of 6 traces; expected one of 2 of 5 traces as in 0.json");
  auto other = report_of(2, 2, 5);
  other.numbers = {1, 2};
  CHECK(problem_of({report_of(1, 2, 5), other}) ==
        "1.json: has trace 3, and so has 0.json; expected each once: the inputs differed where the shards ran");
  other.numbers = {1};
  CHECK(problem_of({report_of(1, 2, 5), other}) ==
        "--merge: no report has trace 4: the inputs differed where the shards ran");
}
