#include "continua/replay/inspector/run_dropped.h"

#include <filesystem>

#include "continua/core/located_json.h"
#include "support/catch.h"

using namespace continua;
using Catch::Matchers::Contains;

namespace {

std::string refused(DroppedFiles& files, const DroppedPart& part) {
  const auto taken = files.add(part);
  return taken ? "" : taken.error().sentence;
}

}  // namespace

TEST_CASE("a file comes in parts, in their order, and is known by its first line") {
  RunTemporary temporary;
  DroppedFiles files(temporary);
  const auto first = files.add({"k1", "../my talk.jsonl", 0, false, "{\"kind\":\"tra"});
  REQUIRE(first.ok());
  CHECK(!*first);
  const auto last = files.add({"k1", "../my talk.jsonl", 1, true, "ce\"}\n"});
  REQUIRE(last.ok());
  REQUIRE(last->has_value());
  const auto& file = **last;
  CHECK(file.is_trace);
  CHECK(file.name == "my_talk");
  CHECK(std::filesystem::path(file.path).filename() == "my_talk.trace.jsonl");
  CHECK(read_file(file.path).value() == "{\"kind\":\"trace\"}\n");
}

TEST_CASE("parts out of order, strange keys and other files are refused, and nothing is kept of them") {
  RunTemporary temporary;
  DroppedFiles files(temporary);
  CHECK_THAT(refused(files, {"../x", "a", 0, true, "{}"}), Contains("letters and digits"));
  CHECK_THAT(refused(files, {"k1", "a", 1, false, "x"}), Contains("given up"));
  CHECK(refused(files, {"k2", "a", 0, false, "x"}).empty());
  CHECK_THAT(refused(files, {"k2", "a", 2, false, "x"}), Contains("expected part 1"));
  CHECK_THAT(refused(files, {"k2", "a", 1, false, "x"}), Contains("given up"));
  CHECK_THAT(refused(files, {"k3", "a.png", 0, true, "PNG"}), Contains("no run log and no trace"));
}

TEST_CASE("of files that are never finished only the latest are kept") {
  RunTemporary temporary;
  DroppedFiles files(temporary);
  for (const auto* key : {"a", "b", "c", "d", "e"}) CHECK(refused(files, {key, "x", 0, false, "x"}).empty());
  CHECK_THAT(refused(files, {"a", "x", 1, false, "x"}), Contains("given up"));
  CHECK(refused(files, {"e", "x", 1, false, "x"}).empty());
}

TEST_CASE("a file that is too large is let go of") {
  RunTemporary temporary;
  DroppedFiles files(temporary);
  const std::string part(std::size_t{1} << 20, ' ');
  for (std::size_t i = 0; i < most_dropped_bytes / part.size(); ++i)
    REQUIRE(refused(files, {"big", "x", i, false, part}).empty());
  CHECK_THAT(refused(files, {"big", "x", most_dropped_bytes / part.size(), false, part}), Contains("more than 64 MiB"));
}
