// Traces and runs as annotations, and back.
#include <filesystem>

#include "continua/replay/annotation/eaf.h"
#include "continua/replay/annotation/run_tiers.h"
#include "continua/replay/annotation/textgrid.h"
#include "continua/replay/annotation/tier_import.h"
#include "support/catch.h"
#include "support/folders.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

TierMap own_map(const Annotations& annotations) { return guessed_map(annotations, {}); }

Trace imported(const Result<Annotations>& annotations) {
  if (!annotations) FAIL(annotations.error().text());
  auto trace = trace_of_annotations(*annotations, own_map(*annotations));
  if (!trace) FAIL(trace.error().text());
  return *std::move(trace);
}

Trace trace_of(const std::string& events) {
  auto trace = read_trace_text(
      "{\"kind\":\"trace\",\"version\":1,\"scene\":\"place_setting\",\"machine\":\"interaction\"}\n" + events, "t");
  if (!trace) FAIL(trace.error().text());
  return *std::move(trace);
}

void replace(std::string& text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) FAIL(from + " is not there");
  text.replace(at, from.size(), to);
}

const Tier* tier(const Annotations& annotations, const std::string& name) {
  for (const auto& each : annotations.tiers)
    if (each.name == name) return &each;
  return nullptr;
}

TEST_CASE("A trace comes back from ELAN and Praat as it was") {
  std::size_t traces = 0;
  for (const auto& file : fs::recursive_directory_iterator(fs::path(source_dir()) / "traces")) {
    if (!file.path().string().ends_with(".trace.jsonl")) continue;
    const auto trace = read_trace(file.path().string());
    REQUIRE(trace);
    if (trace->events.empty()) continue;
    INFO(file.path().string());
    const auto annotations = annotations_of_trace(*trace);
    CHECK(write_trace(imported(read_eaf(eaf_of(annotations), "t.eaf"))) == write_trace(*trace));
    CHECK(write_trace(imported(read_textgrid(textgrid_of(annotations), "t.TextGrid"))) == write_trace(*trace));
    ++traces;
  }
  CHECK(traces > 60);
}

TEST_CASE("Annotations of a tier never overlap and are never empty") {
  const auto annotations = annotations_of_trace(trace_of(R"({"t":1,"kind":"speech","text":"take","until":3}
{"t":1,"kind":"speech","text":"the"}
{"t":1.0004,"kind":"speech","text":"cup","until":1.0004}
)"));
  const auto* speech = tier(annotations, "human speech");
  REQUIRE(speech);
  REQUIRE(speech->annotations.size() == 3);
  std::int64_t reached = 0;
  for (const auto& each : speech->annotations) {
    CHECK(each.begin_ms >= reached);
    CHECK(each.end_ms > each.begin_ms);
    reached = each.end_ms;
  }
}

TEST_CASE("An annotation that was moved in ELAN takes its event along") {
  const auto trace = trace_of(
      R"({"t":1.000001,"kind":"speech","text":"the cup","until":2,"confidence":0.5,"words":[{"text":"the","t":1.1}]})"
      "\n");
  auto eaf = eaf_of(annotations_of_trace(trace));
  replace(eaf, R"(TIME_VALUE="1000")", R"(TIME_VALUE="1500")");
  replace(eaf, R"(TIME_VALUE="2000")", R"(TIME_VALUE="2500")");
  const auto back = imported(read_eaf(eaf, "t.eaf"));
  CHECK(
      write_event(back.events.at(0)) ==
      R"({"t":1.500001,"kind":"speech","text":"the cup","until":2.5,"confidence":0.5,"words":[{"text":"the","t":1.6}]})");
}

TEST_CASE("An annotation with another label counts as annotated by hand") {
  auto eaf = eaf_of(annotations_of_trace(
      trace_of("{\"t\":1,\"kind\":\"gesture\",\"name\":\"posack\",\"phase\":\"start\",\"confidence\":0.5}\n")));
  replace(eaf, "<ANNOTATION_VALUE>posack start<", "<ANNOTATION_VALUE>left point 0.1,-0.2<");
  const auto back = imported(read_eaf(eaf, "t.eaf"));
  Json event = Json::parse(write_event(back.events.at(0)));
  event.erase("row");
  CHECK(event ==
        Json::parse(R"({"t":1.0,"kind":"gesture","name":"point","hand":"left","target":[0.1,-0.2],"until":2.5})"));
}

TEST_CASE("A map may use exported tiers otherwise") {
  const auto annotations = read_eaf(eaf_of(annotations_of_trace(trace_of(R"({"t":1,"kind":"speech","text":"hi"})"
                                                                         "\n"))),
                                    "t.eaf");
  const auto map = parse_tier_map(R"({"tiers":{"human speech":{"kind":"observed","channel":"speech"}}})", "m");
  const auto trace = trace_of_annotations(*annotations, *map);
  REQUIRE(trace);
  Json event = Json::parse(write_event(trace->events.at(0)));
  event.erase("row");
  CHECK(event == Json::parse(R"({"t":1.0,"kind":"observed","channel":"speech","content":"hi"})"));
}

TEST_CASE("A run's annotations lead back to its records") {
  const auto run = RunIndex::open(source_dir() + "/traces/building_blocks.run.jsonl");
  REQUIRE(run);
  const auto annotations = annotations_of_run(*run, {{4, 6, "look here"}});
  REQUIRE(annotations);
  const auto* states = tier(*annotations, "state");
  REQUIRE(states);
  CHECK(states->annotations.at(1).value == "BeginInteraction → Wait");
  for (const auto& state : states->annotations)
    if (state.n > 0) CHECK(run->kind(state.n) == "transition");
  const auto* said = tier(*annotations, "avatar speech");
  REQUIRE(said);
  CHECK(said->annotations.at(0).value == "Hello.");
  CHECK(run->record(said->annotations.at(0).n)->at("text") == "Hello.");
  REQUIRE(tier(*annotations, "note"));
  CHECK(tier(*annotations, "note")->annotations.at(0).value == "look here");
  CHECK(eaf_of(*annotations) == eaf_of(*annotations_of_run(*run, {{4, 6, "look here"}})));
}

TEST_CASE("The human's side of a run is that of its trace") {
  const auto run = RunIndex::open(source_dir() + "/traces/building_blocks.run.jsonl");
  const auto trace = read_trace(source_dir() + "/traces/building_blocks.trace.jsonl");
  REQUIRE(run);
  REQUIRE(trace);
  const auto back = imported(read_eaf(eaf_of(*annotations_of_run(*run, {})), "b.eaf"));
  std::vector<std::string> before, after;
  for (const auto& event : trace->events)
    if (!std::holds_alternative<End>(event.what)) before.push_back(write_event(event));
  for (const auto& event : back.events) after.push_back(write_event(event));
  CHECK(after == before);
}

}  // namespace
}  // namespace continua
