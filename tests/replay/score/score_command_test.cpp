// continua score: traces as they are replayed, from a system that answers at once and from a person in its place.
#include "continua/replay/commands/score.h"

#include <filesystem>

#include "continua/core/located_json.h"
#include "support/catch.h"
#include "support/standard_output.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

// Answers at once; another block than the engine's, and silence where the engine asks.
const std::string at_once = R"json({"kind":"trace","version":1,"scene":"staircase","machine":"diana2018"}
{"t":1,"kind":"gesture","name":"engage","phase":"start"}
{"t":1,"kind":"observed","channel":"speech","content":"Hello."}
{"t":2,"kind":"pointing","hand":"right","target":[-0.142,0.066]}
{"t":3,"kind":"gesture","name":"point","hand":"right","phase":"start","target":[-0.142,0.066]}
{"t":3,"kind":"observed","channel":"speech","content":"Are you pointing at this?"}
{"t":3,"kind":"observed","channel":"gesture","content":"look_at(<-0.142, 0.066, 0.002>)"}
{"t":3,"kind":"observed","channel":"gesture","content":"point(rHand, <-0.142, 0.066, 0.002>)"}
{"t":5,"kind":"speech","text":"Yes"}
{"t":5,"kind":"observed","channel":"speech","content":"The black block?"}
{"t":7,"kind":"speech","text":"No"}
{"t":9,"kind":"gesture","name":"engage","phase":"stop"}
{"t":9,"kind":"observed","channel":"speech","content":"Bye!"}
)json";

// Takes 0.7 s to answer; the hand points all the while, once at the instant of an answer.
const std::string person = R"json({"kind":"trace","version":1,"scene":"place_setting","machine":"interaction"}
{"t":0.9,"kind":"pointing","hand":"right","target":[-0.1,-0.15]}
{"t":1,"kind":"speech","text":"Put it there."}
{"t":1.1,"kind":"pointing","hand":"right","target":[-0.1,-0.15]}
{"t":1.4,"kind":"pointing","hand":"right","target":[-0.1,-0.15]}
{"t":1.7,"kind":"pointing","hand":"right","target":[-0.1,-0.15]}
{"t":1.7,"kind":"observed","channel":"speech","content":"What should I put there?"}
{"t":4,"kind":"speech","text":"The plate."}
{"t":4.1,"kind":"pointing","hand":"right","target":[-0.1,-0.15]}
{"t":4.7,"kind":"observed","channel":"action","content":"put(plate, <-0.1, -0.15, 0>)"}
{"t":4.8,"kind":"observed","channel":"speech","content":"Okay, the white plate there."}
{"t":8,"kind":"end"}
)json";

const std::string alone = R"json({"kind":"trace","version":1,"scene":"staircase","machine":"diana2018"}
{"t":1,"kind":"gesture","name":"engage","phase":"start"}
)json";

ScoreOptions options_of(std::vector<std::string> traces) {
  ScoreOptions options;
  options.traces = std::move(traces);
  options.json = true;
  options.replay.physics = false;
  return options;
}

Json scored(const ScoreOptions& options, int expected_status = exit_done) {
  const auto [status, text] = told([&] { return run_score(options); });
  REQUIRE(status == expected_status);
  return Json::parse(text);
}

}  // namespace

TEST_CASE("score holds a run against a system that answers at once") {
  const TemporaryFolder folder;
  const auto score = scored(options_of({folder.file("a.trace.jsonl", at_once)}));
  CHECK(score["variant"] == "free");
  const auto& a = score["traces"].at(0);
  CHECK(a["trace"] == "a");
  CHECK(a["run"].is_null());
  CHECK(a["inputs"] == 5);
  CHECK(a["speaking"] == 4);
  CHECK(a["exact"] == 3);
  CHECK(a["lax"] == 3);
  CHECK(a["template"] == 4);
  CHECK(a["spurious"] == 1);
  CHECK(a["samples"] == 1);
  CHECK(a["silent_samples"] == 1);
  REQUIRE(a["misses"].size() == 2);
  CHECK(a["misses"][0]["t"] == 5.0);
  CHECK(a["misses"][0]["line"] == 9);
  CHECK(a["misses"][0]["input"] == "speech yes");
  CHECK(a["misses"][0]["level"] == "template");
  CHECK(a["misses"][0]["produced"][0]["content"] == "The red block?");
  CHECK(a["misses"][1]["line"] == 11);
  CHECK(a["misses"][1]["observed"].empty());
}

TEST_CASE("score takes what a person answered after a while for the answer to the words") {
  const TemporaryFolder folder;
  const auto score = scored(options_of({folder.file("person.trace.jsonl", person)}));
  const auto& total = score["total"];
  CHECK(total["inputs"] == 2);
  CHECK(total["speaking"] == 2);
  CHECK(total["exact"] == 2);
  CHECK(total["spurious"] == 0);
  CHECK(total["f1"] == 1);
  CHECK(total["samples"] == 5);
  CHECK(total["silent_samples"] == 5);
  CHECK(score["kinds"].size() == 2);
  CHECK(score["kinds"][1]["kind"] == "put(_, _)");
}

TEST_CASE("score tells the same whatever the number of jobs, and keeps the run logs where it is told to") {
  const TemporaryFolder folder;
  auto options = options_of({folder.file("a.trace.jsonl", at_once), folder.file("person.trace.jsonl", person),
                             folder.file("b.trace.jsonl", at_once)});
  const auto one = scored(options);
  REQUIRE(one["traces"].size() == 3);
  CHECK(one["traces"][0]["trace"] == "a");
  CHECK(one["traces"][2]["trace"] == "b");
  options.jobs = 3;
  CHECK(scored(options) == one);
  options.output = folder.at("deep/runs");
  const auto kept = scored(options);
  CHECK(kept["total"] == one["total"]);
  CHECK(kept["traces"][1]["run"] == folder.at("deep/runs/person.run.jsonl"));
  CHECK(fs::file_size(folder.at("deep/runs/b.run.jsonl")) > 1000);
}

TEST_CASE("score follows what was observed if it is told to") {
  const TemporaryFolder folder;
  auto options = options_of({folder.file("a.trace.jsonl", at_once)});
  options.replay.variant = Variant::teacher;
  const auto score = scored(options);
  CHECK(score["variant"] == "teacher");
  CHECK(score["total"]["speaking"] == 4);
}

TEST_CASE("score uses the machine, the scene and the seed that it is given") {
  const TemporaryFolder folder;
  auto options = options_of({folder.file("a.trace.jsonl", at_once)});
  options.replay.machine = "table_1";
  CHECK(scored(options)["total"]["exact"] == 0);
  options.replay.machine = "no such machine";
  CHECK(scored(options, exit_impossible)["traces"].empty());
}

TEST_CASE("score scores what it can and reports the rest") {
  const TemporaryFolder folder;
  const auto good = folder.file("a.trace.jsonl", at_once), bad = folder.file("bad.trace.jsonl", "{}\n");
  auto options = options_of({bad, folder.at("none.trace.jsonl"), good});
  const auto score = scored(options, exit_impossible);
  REQUIRE(score["traces"].size() == 1);
  CHECK(score["total"]["speaking"] == 4);
  options.traces = {good, folder.file("other/a.trace.jsonl", at_once)};
  options.output = folder.at("runs");
  CHECK(told([&] { return run_score(options); }).first == exit_impossible);
  CHECK_FALSE(fs::exists(folder.at("runs/a.run.jsonl")));
  options.traces = {good};
  options.output = folder.file("file", "");
  CHECK(told([&] { return run_score(options); }).first == exit_impossible);
}

TEST_CASE("a trace of which nothing was observed counts nothing") {
  const TemporaryFolder folder;
  const auto score = scored(options_of({folder.file("alone.trace.jsonl", alone)}));
  CHECK(score["traces"].size() == 1);
  CHECK(score["total"]["inputs"] == 0);
  CHECK(score["total"]["spurious"] == 0);
  CHECK(score["total"]["f1"] == 1);
}

TEST_CASE("score tells tables, or Markdown") {
  const TemporaryFolder folder;
  auto options = options_of({folder.file("a.trace.jsonl", at_once)});
  options.json = false;
  const auto text = told([&] { return run_score(options); }).second;
  CHECK(text.find("observed: “The black block?”\n  came out: “The red block?”") != std::string::npos);
  options.markdown = true;
  CHECK(told([&] { return run_score(options); }).second.starts_with("| trace |"));
}
