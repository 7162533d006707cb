#include "continua/replay/inspector/run_agreement.h"

#include <filesystem>
#include <sstream>

#include "continua/replay/score/score.h"
#include "continua/replay/session/session.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;

TEST_CASE("a run's log tells of the observed answers what its replay does") {
  const auto trace = std::filesystem::path(source_dir()) / "traces/talk/wizard.trace.jsonl";
  ReplayOptions options;
  options.physics = false;
  options.episodes = true;
  auto session = Session::load(trace.string(), options);
  REQUIRE(session.ok());
  std::ostringstream log;
  const auto summary = session->run(log);
  Score score;
  std::size_t misses = 0;
  for (const auto& episode : summary.episodes) score.add(episode), misses += is_miss(episode);
  REQUIRE(score.speaking > score.lax);

  const auto run = RunIndex::of_text(log.str(), "wizard");
  REQUIRE(run.ok());
  const auto told = run_agreement(*run);
  REQUIRE(told.ok());
  CHECK((*told)["answers"] == score.speaking);
  CHECK((*told)["alike"] == score.lax);
  CHECK((*told)["misses"].size() == misses);
  for (const auto& n : (*told)["misses"]) CHECK(run->kind(n.get<std::size_t>()) == "observed");
}

TEST_CASE("an answer where nothing was observed is a miss, told by itself") {
  LogBuilder log;
  log.add("run", 0, {{"version", 1}});
  const auto first = log.add("input", 1, {{"event", {{"kind", "speech"}, {"text", "Yes."}}}});
  log.add("utterance", 1, {{"text", "Okay."}}, static_cast<int>(first));
  log.add("observed", 1.5, {{"channel", "speech"}, {"content", "Okay."}});
  const auto second = log.add("input", 2, {{"event", {{"kind", "speech"}, {"text", "No."}}}});
  const auto odd = log.add("utterance", 2, {{"text", "Why?"}}, static_cast<int>(second));
  const auto run = RunIndex::of_text(log.text(), "run");
  REQUIRE(run.ok());
  CHECK(*run_agreement(*run) == Json{{"answers", 1}, {"alike", 1}, {"misses", {odd}}});
}

TEST_CASE("of a run with nothing observed there is nothing to tell") {
  LogBuilder log;
  log.add("run", 0, {{"version", 1}});
  const auto run = RunIndex::of_text(log.text(), "run");
  REQUIRE(run.ok());
  CHECK(run_agreement(*run)->is_null());
}
