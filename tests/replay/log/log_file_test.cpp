// Run logs that are packed with gzip, in blocks or otherwise: the same records as in the plain ones.
#include "continua/replay/log/log_file.h"

#include <filesystem>

#include <fmt/format.h>
#include <rapidcheck.h>

#include "continua/core/gzip.h"
#include "continua/core/located_json.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/log/run_log_file.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const std::string header =
    R"({"kind":"run","n":0,"t":0,"version":1,"knowledge":{"a":")" + std::string(900, 'k') + "\"}}\n";

// Records of random lengths.
std::string log_of(std::size_t bytes, unsigned seed) {
  auto text = header;
  std::size_t n = 1;
  for (; text.size() < bytes; ++n) {
    seed = seed * 1664525U + 1013904223U;
    text += compact({{"kind", n % 3 ? "problem" : "transition"},
                     {"n", n},
                     {"t", n},
                     {"cause", n - 1},
                     {"text", fmt::format("{:x}", seed) + std::string(seed >> 23U, '.')}}) +
            "\n";
  }
  return text + compact({{"kind", "end"}, {"n", n}, {"t", n}}) + "\n";
}

std::string packed(const TemporaryFolder& folder, const std::string& text, const std::string& documents = "") {
  const auto path = folder.at("a.run.jsonl.gz");
  RunLogFile file(path, documents);
  file.stream() << text;
  REQUIRE(!file.commit());
  return path;
}

// The error of opening, which reading the whole log gives too if it fails.
std::string problem_of(const std::string& path) {
  const auto text = read_run_log(path);
  const auto run = RunIndex::open(path);
  if (run.ok()) return "none";
  if (!text.ok()) CHECK(text.error().sentence == run.error().sentence);
  return run.error().text();
}

}  // namespace

TEST_CASE("a packed log has the records of the plain one, each at its place") {
  CHECK(rc::check([] {
    const TemporaryFolder folder;
    const auto text = log_of(*rc::gen::inRange<std::size_t>(0, 400000), *rc::gen::arbitrary<unsigned>());
    const auto plain = RunIndex::of_text(text, "plain").value();
    for (const auto& path : {packed(folder, text), folder.file("b.run.jsonl.gz", gzipped(text))}) {
      RC_ASSERT(read_run_log(path).value() == text);
      const auto run = RunIndex::open(path).value();
      RC_ASSERT(run.size() == plain.size());
      RC_ASSERT(run.bytes() == text.size());
      for (int i = 0; i < 20; ++i) {
        const auto n = *rc::gen::inRange<std::size_t>(0, run.size());
        RC_ASSERT(run.line(n).value() == plain.line(n).value());
      }
    }
  }));
}

TEST_CASE("a packed log may have its documents beside it") {
  const TemporaryFolder folder;
  const auto text = log_of(5000, 1);
  const auto path = packed(folder, text, folder.at("documents"));
  CHECK(fs::exists(folder.at("documents")));
  CHECK(first_line(path).value().size() < 200);
  CHECK(read_run_log(path).value() == text);
  CHECK(!rewrite_run_log(path, folder.at("b.run.jsonl")));
  CHECK(read_file(folder.at("b.run.jsonl")).value() == text);
}

TEST_CASE("the index of a long packed log is kept, and leads to the same lines") {
  const TemporaryFolder folder;
  const auto text = log_of(12 << 20, 7);
  for (const auto& path : {packed(folder, text), folder.file("b.run.jsonl.gz", gzipped(text))}) {
    const auto fresh = RunIndex::open(path);
    REQUIRE(fresh.ok());
    REQUIRE(fs::exists(path + ".index"));
    const auto kept = RunIndex::open(path);
    REQUIRE(kept.ok());
    CHECK(kept->size() == fresh->size());
    for (std::size_t n = 0; n < kept->size(); n += kept->size() / 50)
      CHECK(kept->line(kept->size() - 1 - n).value() == fresh->line(kept->size() - 1 - n).value());
  }
}

TEST_CASE("a packed log that is cut or damaged is refused with its place") {
  const TemporaryFolder folder;
  const auto text = log_of(3 << 20, 3);
  const auto bytes = read_file(packed(folder, text)).value();
  const auto in_one = gzipped(text);
  const auto problem = [&](const std::string& damaged) {
    return problem_of(folder.file("bad.run.jsonl.gz", damaged)).substr(folder.path().string().size() + 1);
  };
  CHECK(problem(bytes.substr(0, 100)) ==
        "bad.run.jsonl.gz:1: is cut short: its packed bytes end in the midst; expected a whole gzip file");
  CHECK(problem(bytes.substr(0, bytes.size() - 28)).starts_with("bad.run.jsonl.gz: is cut short"));
  CHECK(problem(in_one.substr(0, in_one.size() / 2)).find("is cut short") != std::string::npos);
  CHECK(problem("\x1f\x8b").starts_with("bad.run.jsonl.gz:1: is cut short"));
  CHECK(problem("\x1f\x8b and what not").starts_with("bad.run.jsonl.gz:1: is damaged"));
  auto other = bytes;
  other[bytes.size() - 40] ^= 1;
  CHECK(problem(other).find("is damaged") != std::string::npos);
  CHECK(problem(gzipped("hello\n")).find("not a run log") != std::string::npos);
  CHECK(problem(gzipped(std::string(100 << 20, ' '))).find("becomes more than 200 times as long") != std::string::npos);

  // Damaged behind the place where a reader has been, after the index was kept.
  const auto path = packed(folder, log_of(12 << 20, 7));
  REQUIRE(RunIndex::open(path).ok());
  const auto run = RunIndex::open(path);
  REQUIRE(run.ok());
  fs::resize_file(path, fs::file_size(path) / 2);
  const auto last = run->line(run->size() - 1);
  REQUIRE(!last.ok());
  CHECK(last.error().text() ==
        fmt::format("{}:{}: is damaged: its packed bytes cannot be unpacked here; expected a whole gzip file", path,
                    run->size()));
}
