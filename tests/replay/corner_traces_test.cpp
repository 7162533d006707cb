// The repository's odd traces are valid.
#include <filesystem>

#include "continua/replay/trace/trace_file.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

Trace corner(const std::string& name) {
  auto trace = read_trace((fs::path(source_dir()) / "traces/corner" / (name + ".trace.jsonl")).string());
  INFO((trace ? "" : trace.error().text()));
  REQUIRE(trace);
  return std::move(trace).value();
}

}  // namespace

TEST_CASE("every trace of the repository can be read") {
  std::size_t traces = 0;
  for (const auto& entry : fs::recursive_directory_iterator(fs::path(source_dir()) / "traces")) {
    const auto name = entry.path().filename().string();
    if (!name.ends_with(".jsonl") || name.ends_with(".run.jsonl")) continue;
    ++traces;
    const auto trace = read_trace(entry.path().string());
    INFO((trace ? "" : trace.error().text()));
    CHECK(trace.ok());
  }
  CHECK(traces > 0);
}

TEST_CASE("odd traces hold what their names say") {
  CHECK(corner("header_only").events.empty());
  CHECK(corner("carriage_returns_and_byte_order_mark").events.size() == 2);
  CHECK(corner("unknown_kinds_and_fields").notes.size() == 1);
  CHECK(std::get<InputEvent>(corner("wild_pointing").events.at(2).what).target_W->x() == 13470.7);
  CHECK(corner("all_at_once").events.back().t == corner("all_at_once").events.front().t);
  CHECK(std::get<InputEvent>(corner("alternatives").events.at(1).what).text == "RED");
  CHECK(corner("removed_objects").header.objects.at(1).second.removed);
}
