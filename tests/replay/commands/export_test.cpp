// Exports of a trace, which is replayed for them.
#include "continua/replay/commands/export.h"

#include "continua/core/located_json.h"
#include "continua/replay/commands/replay.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;

namespace {

const std::string trace = R"({"kind":"trace","version":1,"scene":"place_setting","machine":"interaction"}
{"t":1,"kind":"speech","text":"Take the knife."}
{"t":3,"kind":"end"}
)";

// The file that the export of `input` writes; empty: it was refused.
std::string exported(const TemporaryFolder& folder, const std::string& input, const std::string& format,
                     const Json& settings) {
  ExportOptions options;
  options.runs = {input};
  options.format = format;
  options.output = folder.at("out");
  options.replay.physics = false;
  options.replay.settings = settings;
  std::filesystem::remove(options.output);
  if (run_export(options) != exit_done) return "";
  return read_file(options.output).value();
}

}  // namespace

TEST_CASE("A trace is exported as its run is, with what is set") {
  const TemporaryFolder folder;
  const auto path = folder.file("talk.trace.jsonl", trace);
  for (const auto& settings : {Json::object(), Json{{"surer_by", 0.25}}}) {
    ReplayCommandOptions replay;
    replay.traces = {path};
    replay.replay.physics = false;
    replay.replay.settings = settings;
    replay.output = folder.at("talk.run.jsonl");
    REQUIRE(run_replay(replay) == exit_done);
    for (const std::string format : {"jsonl", "csv", "html"}) {
      const auto of_run = exported(folder, replay.output, format, Json::object());
      CHECK(!of_run.empty());
      CHECK(exported(folder, path, format, settings) == of_run);
    }
  }
}

TEST_CASE("A value is set of a replay alone") {
  const TemporaryFolder folder;
  const Json settings{{"surer_by", 0.25}};
  const auto path = folder.file("talk.trace.jsonl", trace);
  const auto run = folder.file("talk.run.jsonl", exported(folder, path, "jsonl", settings));
  CHECK(exported(folder, run, "csv", settings).empty());
  CHECK(exported(folder, run, "site", settings).empty());
  CHECK(exported(folder, path, "csv", {{"surer_bye", 0.25}}).empty());
  CHECK(exported(folder, path, "vtt", settings) == exported(folder, run, "vtt", Json::object()));
}
