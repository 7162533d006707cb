// Pictures of both scenes on the page of a failure.
#include "continua/replay/check/world_pictures.h"

#include <fmt/format.h>

#include "replay/inspector/inspector_log.h"

using namespace continua;

namespace {

// Tells of each picture which run and which instant it was asked for.
class Frames : public RunFrames {
 public:
  Outcome cannot;

  Outcome unavailable() override { return cannot; }
  Outcome wrong_size(const std::string&) override { return std::nullopt; }
  Result<std::string> png(const std::shared_ptr<const RunIndex>& run, SimTime t, const std::string&) override {
    if (run->path() == "odd") return Error{"odd:1", "has no scene"};
    return fmt::format("{} {}", run->path(), t.seconds());
  }
};

RunIndex run_that_says(const std::string& name, const std::string& text, double t) {
  LogBuilder log;
  log.add("run", 0, {{"version", 1}});
  log.add("utterance", 1, {{"text", "Hello."}});
  log.add("utterance", t, {{"text", text}});
  log.add("end", 9, {{"counts", Json::object()}});
  return RunIndex::of_text(log.text(), name).value();
}

ComparedRuns compared(const std::string& name) {
  auto approved = run_that_says(name, "The plate.", 2), run = run_that_says("now", "The cup.", 3);
  auto diff = diff_runs(approved, run).value();
  return {std::move(approved), std::move(run), std::move(diff)};
}

}  // namespace

TEST_CASE("the scenes are drawn where the runs part, each at its own instant, and at the end") {
  const auto worlds = pictures_of(compared("approved"), std::make_shared<Frames>());
  REQUIRE(worlds.size() == 2);
  REQUIRE(worlds[0].sides.size() == 2);
  CHECK(worlds[0].sides[0].title == "A: approved, at 0:02");
  CHECK(worlds[0].sides[0].png == "YXBwcm92ZWQgMg==");  // "approved 2"
  CHECK(worlds[0].sides[1].title == "B: now, at 0:03");
  CHECK(worlds[0].sides[1].png == "bm93IDM=");  // "now 3"
  CHECK(worlds[1].sides[1].title == "B: now, at 0:09");
}

TEST_CASE("where no picture can be drawn, its place says why") {
  const auto frames = std::make_shared<Frames>();
  CHECK(pictures_of(compared("odd"), frames)[0].sides[0].trouble == "has no scene");
  CHECK(pictures_of(compared("odd"), frames)[0].sides[1].trouble.empty());
  frames->cannot = Error{"", "EGL gives no display"};
  for (const auto& world : pictures_of(compared("approved"), frames))
    for (const auto& side : world.sides) {
      CHECK(side.png.empty());
      CHECK(side.trouble == "EGL gives no display");
    }
}
