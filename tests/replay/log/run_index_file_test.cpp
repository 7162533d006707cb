// The index of a long log, kept next to the log.
#include <filesystem>
#include <fstream>

#include "continua/replay/log/run_index.h"
#include "continua/replay/log/run_index_file.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

std::string long_log(const std::string& word) {
  std::string log = R"({"kind":"run","n":0,"t":0,"version":1})"
                    "\n";
  for (int n = 1; log.size() < (std::size_t{9} << 20); ++n) {
    Json record{{"kind", n % 2 ? "symbol" : "transition"}, {"n", n}, {"t", n * 0.01}};
    if (n % 2)
      record.update(
          {{"id", n}, {"below", n > 1 ? Json(n - 2) : Json()}, {"slots", {{"word", word + std::string(400, '.')}}}});
    else
      record.update({{"id", "go"}, {"from", "A"}, {"to", "B"}, {"stack", n - 1}, {"cause", n - 1}});
    log += compact(record) + "\n";
  }
  return log;
}

// All that an index tells of a log.
std::string told(const RunIndex& run) {
  std::string all;
  for (std::size_t n = 0; n < run.size(); n += 7) {
    const auto& entry = run.entry(n);
    all += run.kind(n) + std::to_string(entry.offset) + " " + std::to_string(entry.length) + " " +
           std::to_string(entry.meaning.what) + " " + std::to_string(entry.meaning.whole) + " " +
           std::to_string(entry.cause) + " " + std::to_string(entry.t.us) + " ";
  }
  const auto* top = run.symbol(run.stack_marks().back().top);
  return all + std::to_string(run.stack_marks().size()) + " " + std::to_string(top ? top->stack : 0) + run.trouble();
}

}  // namespace

TEST_CASE("the kept index of a log is what reading the log gives") {
  const TemporaryFolder folder;
  const auto path = folder.file("long.run.jsonl", long_log("first"));
  const auto index = path + ".index";
  const auto fresh = RunIndex::open(path);
  REQUIRE(fresh.ok());
  REQUIRE(fs::exists(index));
  const auto expected = told(*fresh);
  const auto kept = RunIndex::open(path);
  REQUIRE(kept.ok());
  CHECK(told(*kept) == expected);
  CHECK(*kept->line(2) == *fresh->line(2));

  SECTION("a damaged one is made anew") {
    for (const std::uintmax_t at : {fs::file_size(index) / 2, std::uintmax_t{5}, fs::file_size(index) - 3}) {
      {
        std::fstream file(index, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(static_cast<std::streamoff>(at));
        file.write("!!!", 3);
      }
      const auto again = RunIndex::open(path);
      REQUIRE(again.ok());
      CHECK(told(*again) == expected);
    }
  }
  SECTION("a cut one too") {
    fs::resize_file(index, fs::file_size(index) / 3);
    const auto again = RunIndex::open(path);
    REQUIRE(again.ok());
    CHECK(told(*again) == expected);
  }
  SECTION("of another log it does not count") {
    folder.file("long.run.jsonl", long_log("other"));
    const auto other = RunIndex::open(path);
    REQUIRE(other.ok());
    CHECK(told(*other) != expected);
    CHECK(other->symbol(1)->stack != fresh->symbol(1)->stack);
  }
}

// A digest is no secret: an index may be forged so that it agrees with itself.
TEST_CASE("an index that sends its readers out of the log, or in a circle, does not count") {
  const TemporaryFolder folder;
  const auto path = folder.file("long.run.jsonl", long_log("first"));
  const auto fresh = RunIndex::open(path);
  REQUIRE(fresh.ok());
  const auto expected = told(*fresh);
  const auto print = print_of(path);
  REQUIRE(print);
  const auto scan = kept_scan(path, *print);
  REQUIRE(scan);
  const auto forged = [&](auto change) {
    auto log = *scan;
    change(log);
    keep_scan(log, *print);
    const bool believed = kept_scan(path, *print).has_value();
    const auto again = RunIndex::open(path);
    return !believed && again.ok() && told(*again) == expected;
  };
  CHECK(forged([](ScannedLog& log) { log.entries[10].cause = 1'000'000'000'000; }));
  CHECK(forged([](ScannedLog& log) { log.entries[10].cause = 10; }));
  CHECK(forged([](ScannedLog& log) { log.entries[10].cause = 12, log.entries[12].cause = 10; }));
  CHECK(forged([](ScannedLog& log) { log.entries[10].cause = -2; }));
  CHECK(forged([](ScannedLog& log) { log.entries[10].offset = log.entries[11].offset; }));
  CHECK(forged([](ScannedLog& log) { log.entries.back().offset = log.bytes + 1; }));
  CHECK(forged([](ScannedLog& log) { std::swap(log.entries[10].offset, log.entries[12].offset); }));
}

TEST_CASE("a record that is not where the index has it is an error, and no other record is given for it") {
  const TemporaryFolder folder;
  const auto path = folder.file("long.run.jsonl", long_log("first"));
  REQUIRE(RunIndex::open(path).ok());
  const auto print = print_of(path);
  REQUIRE(print);
  auto log = kept_scan(path, *print).value();
  // One record less, and everything else in order.
  for (std::size_t n = 10; n + 1 < log.entries.size(); ++n)
    log.entries[n].offset = log.entries[n + 1].offset, log.entries[n].length = log.entries[n + 1].length;
  log.entries.pop_back();
  log.marks.pop_back();
  log.steps.pop_back();
  for (auto symbol = log.symbols.begin(); symbol != log.symbols.end();)
    symbol = symbol->second.n >= log.entries.size() ? log.symbols.erase(symbol) : std::next(symbol);
  keep_scan(log, *print);
  const auto forged = RunIndex::open(path);
  REQUIRE(forged.ok());
  REQUIRE(forged->size() == log.entries.size());
  CHECK(forged->record(9).ok());
  REQUIRE_FALSE(forged->record(10).ok());
  CHECK(forged->record(10).error().text().find("long.run.jsonl:11: is not where ") != std::string::npos);
  std::size_t used = 0;
  CHECK(forged->read_lines([](std::size_t) { return true; }, [&](std::size_t, std::string_view) { return ++used; }));
  CHECK(used == 10);
}

TEST_CASE("of a short log, and of a log in memory, no index is kept") {
  const TemporaryFolder folder;
  const auto path = folder.file("short.run.jsonl", "{\"kind\":\"run\",\"n\":0,\"t\":0,\"version\":1}\n");
  REQUIRE(RunIndex::open(path).ok());
  CHECK(!fs::exists(path + ".index"));
  REQUIRE(RunIndex::of_text(long_log("x"), folder.at("memory.run.jsonl")).ok());
  CHECK(!fs::exists(folder.at("memory.run.jsonl.index")));
}
