// A log's chain of digests: the block of any changed byte is named.
#include "continua/replay/log/run_integrity.h"

#include <filesystem>
#include <sstream>

#include <fmt/format.h>

#include "continua/replay/diff/run_diff.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/log/run_log.h"
#include "continua/replay/trace/trace_file.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

// A log of so many records, besides its header, its blocks and its end.
std::string log_of(int records) {
  std::ostringstream out;
  RunLog written(out);
  written.write(log::Run{}, SimTime{});
  for (int i = 0; i < records; ++i) {
    const auto t = SimTime::from_seconds(i * 0.1);
    if (i % 3 == 0)
      written.write(log::Utterance{fmt::format("Word {}.", i), {}}, t);
    else if (i % 3 == 1)
      written.write(log::Pose{{{"cup", {i * 0.001, 0, 0, 1, 0, 0, 0}}}}, t);
    else
      written.write(log::Act{i, "grasp(cup)", "done", {}, {}, {}}, t);
  }
  written.finish(SimTime::from_seconds(records * 0.1));
  return out.str();
}

std::string problems(const std::string& log) {
  std::string all;
  for (const auto& problem : integrity_problems(log, "x")) all += problem.text() + "\n";
  return all;
}

std::size_t line_at(const std::string& log, std::size_t byte) {
  return static_cast<std::size_t>(std::count(log.begin(), log.begin() + static_cast<std::ptrdiff_t>(byte), '\n'));
}

}  // namespace

TEST_CASE("a log as it was written is whole, with any number of records") {
  for (const int records : {0, 1, 253, 254, 255, 256, 510, 511, 700}) {
    INFO(records);
    const auto log = log_of(records);
    CHECK(problems(log).empty());
    CHECK(RunIndex::of_text(log, "x").ok());
  }
}

TEST_CASE("the block in which a byte is another is named") {
  const auto log = log_of(900);
  const auto header = log.find('\n') + 1, end = log.rfind('\n', log.size() - 2) + 1;
  for (std::size_t at = header; at < end; at += 97) {
    if (log[at] == '\n') continue;
    auto damaged = log;
    damaged[at] = damaged[at] == 'x' ? 'y' : 'x';
    const auto told = integrity_problems(damaged, "x");
    INFO(at);
    REQUIRE(!told.empty());
    // The first line of the block, or of the lines after the last one.
    const auto line = line_at(log, at);
    const auto named = std::stoul(told.front().where.substr(2)) - 1;
    const auto block = static_cast<std::size_t>(records_per_block);
    INFO(told.front().text());
    CHECK(named <= line);
    if (line % block != block - 1) CHECK(line / block == named / block);
  }
}

TEST_CASE("lines left out, added or exchanged are found") {
  const auto log = log_of(600);
  const auto second = log.find('\n') + 1, third = log.find('\n', second) + 1, fourth = log.find('\n', third) + 1;
  CHECK(!problems(log.substr(0, second) + log.substr(third)).empty());
  CHECK(!problems(log.substr(0, third) + log.substr(second)).empty());
  CHECK(!problems(log.substr(0, second) + log.substr(third, fourth - third) + log.substr(second, third - second) +
                  log.substr(fourth))
             .empty());
  CHECK(problems(log + log.substr(second, third - second)).find("after the log's end") != std::string::npos);
}

TEST_CASE("a log cut anywhere is whole as far as it goes") {
  const auto log = log_of(300);
  for (std::size_t size = 1; size < log.size(); size += 211) {
    INFO(size);
    CHECK(problems(log.substr(0, size)).empty());
    const auto run = RunIndex::of_text(log.substr(0, size), "x");
    if (size < log.find('\n')) continue;
    REQUIRE(run.ok());
    CHECK(run->size() >= line_at(log, size));
    CHECK(!run->trouble().empty());
  }
}

TEST_CASE("what the last line states has to be so") {
  const auto log = log_of(20);
  for (const char* key : {"\"decisions\":\"", "\"physics\":\"", "\"digest\":\"", "\"counts\":{\"act\":"}) {
    auto damaged = log;
    const auto at = damaged.rfind(key) + std::string(key).size();
    damaged[at] = damaged[at] == '1' ? '2' : '1';
    INFO(key);
    CHECK(!problems(damaged).empty());
  }
}

TEST_CASE("logs and traces of every version that was written can be read") {
  const auto folder = fs::path(source_dir()) / "tests/replay/frozen";
  int logs = 0, recorded = 0;
  for (const auto& file : fs::directory_iterator(folder)) {
    if (file.path().string().ends_with(".trace.jsonl")) {
      ++recorded;
      CHECK(read_trace(file.path().string()).ok());
    }
    if (!file.path().string().ends_with(".run.jsonl")) continue;
    ++logs;
    INFO(file.path());
    const auto text = read_file(file.path().string());
    REQUIRE(text.ok());
    CHECK(integrity_problems(*text, "x").empty());
    const auto run = RunIndex::open(file.path().string());
    REQUIRE(run.ok());
    CHECK(run->complete());
    const auto diff = diff_runs(*run, *run);
    REQUIRE(diff.ok());
    CHECK(diff->sameness == RunDiff::Sameness::same);
  }
  CHECK(logs >= 1);
  CHECK(recorded >= 1);
}
