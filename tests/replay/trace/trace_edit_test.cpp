// Traces made of traces.
#include "continua/replay/trace/trace_edit.h"

#include <rapidcheck.h>

#include <filesystem>

#include "continua/replay/trace/trace_event.h"
#include "continua/replay/trace/trace_names.h"
#include "support/catch.h"
#include "support/folders.h"

namespace continua {
namespace {

Trace trace_of(const std::string& events, const std::string& more = "") {
  auto trace =
      read_trace_text("{\"kind\":\"trace\",\"version\":1,\"scene\":\"place_setting\",\"machine\":\"interaction\"" +
                          more + "}\n" + events,
                      "t");
  if (!trace) FAIL(trace.error().text());
  return *std::move(trace);
}

const std::string four =
    R"x({"t":1,"kind":"speech","text":"Lee, take the cup","until":2,"words":[{"text":"Lee","t":1}]}
{"t":2,"kind":"gesture","name":"point","hand":"left","happened":1.5}
{"t":2,"kind":"observed","row":7,"channel":"action","content":"put(cup_blue, on(cup))"}
{"t":4,"kind":"end"}
)x";

std::vector<Trace> all_traces() {
  std::vector<Trace> traces;
  for (const auto& file : std::filesystem::recursive_directory_iterator(std::filesystem::path(source_dir()) / "traces"))
    if (file.path().string().ends_with(".trace.jsonl")) traces.push_back(*read_trace(file.path().string()));
  return traces;
}

TEST_CASE("Cut pieces merge to the trace that they were cut from") {
  const auto traces = all_traces();
  REQUIRE(traces.size() > 60);
  rc::check([&] {
    const auto& trace = traces[*rc::gen::inRange<std::size_t>(0, traces.size())];
    auto cuts = *rc::gen::container<std::vector<std::int64_t>>(rc::gen::inRange<std::int64_t>(0, 30'000'000));
    cuts.push_back(0);
    std::sort(cuts.begin(), cuts.end());
    std::vector<Trace> pieces;
    for (std::size_t i = 0; i < cuts.size(); ++i)
      pieces.push_back(
          cut_trace(trace, {cuts[i]}, i + 1 < cuts.size() ? std::optional(SimTime{cuts[i + 1]}) : std::nullopt));
    const auto merged = merge_traces(pieces);
    RC_ASSERT(merged.ok());
    RC_ASSERT(write_trace(*merged) == write_trace(trace));
  });
}

TEST_CASE("A trace that is shifted there and back is as it was") {
  const auto trace = trace_of(four);
  const auto later = shift_trace(trace, SimTime::from_seconds(2.5));
  REQUIRE(later);
  CHECK(write_event(later->events[0]) ==
        R"({"t":3.5,"kind":"speech","text":"Lee, take the cup","until":4.5,"words":[{"text":"Lee","t":3.5}]})");
  CHECK(later->events[1].t == SimTime::from_seconds(4.5));
  CHECK(std::get<InputEvent>(later->events[1].what).t == SimTime::from_seconds(4));
  CHECK(write_trace(*shift_trace(*later, SimTime::from_seconds(-2.5))) == write_trace(trace));
  CHECK(shift_trace(trace, SimTime::from_seconds(-1.5)).error().text() ==
        "t:2: 't' of speech is -0.5; expected a number from 0 to 1000000000");
}

TEST_CASE("Every trace can be shifted there and back") {
  for (const auto& trace : all_traces()) {
    const auto later = shift_trace(trace, SimTime::from_seconds(2));
    REQUIRE(later);
    CHECK(write_trace(*shift_trace(*later, SimTime::from_seconds(-2))) == write_trace(trace));
  }
}

TEST_CASE("A shift keeps recordings at the events that they show") {
  const auto trace = trace_of(four, R"(,"media":[{"file":"a.wav"},{"file":"b.wav","offset":2.5}])");
  const auto later = shift_trace(trace, SimTime::from_seconds(2.5));
  REQUIRE(later);
  CHECK(compact(later->header.json["media"]) == R"([{"file":"a.wav","offset":-2.5},{"file":"b.wav"}])");
}

TEST_CASE("Traces of other scenes do not merge, and one end stays") {
  const auto one = trace_of(four),
             other = trace_of("{\"t\":3,\"kind\":\"mark\",\"text\":\"x\"}\n{\"t\":3.5,\"kind\":\"end\"}\n");
  const auto merged = merge_traces({one, other});
  REQUIRE(merged);
  CHECK(merged->events.size() == 5);
  CHECK(std::holds_alternative<End>(merged->events.back().what));
  const auto elsewhere = trace_of("", ",\"seed\":2");
  CHECK(merge_traces({one, elsewhere}).error().text() == "t: 'seed' is '2', in t it is '0'; expected the same in all");
}

TEST_CASE("Other names are whole names, and words stay") {
  const auto renamed = rename_in_trace(trace_of(four, R"(,"objects":{"cup":null,"cup_blue":{"yaw":1}})"),
                                       {{"cup", "mug"}, {"point", "show"}});
  REQUIRE(renamed);
  CHECK(renamed->header.objects.at(0).first == "mug");
  CHECK(renamed->header.objects.at(1).first == "cup_blue");
  CHECK(std::get<InputEvent>(renamed->events[0].what).text == "Lee, take the cup");
  CHECK(std::get<InputEvent>(renamed->events[1].what).name == "show");
  CHECK(std::get<Observed>(renamed->events[2].what).content == "put(cup_blue, on(mug))");
  CHECK(rename_in_trace(trace_of(four, R"(,"objects":{"a":null,"b":null})"), {{"a", "b"}}).error().text() ==
        "t:1: two objects would be called 'b'");
}

TEST_CASE("An anonymous trace has no names, no date, no file") {
  const auto anonymous = anonymise_trace(
      trace_of(four, R"(,"recorded":"2018-02-05","source":"Lee.eaf","media":[{"file":"lee.mp4"}])"), {{"lee", "P1"}});
  REQUIRE(anonymous);
  const auto text = write_trace(*anonymous);
  CHECK(text.find("Lee") == std::string::npos);
  CHECK(text.find("2018") == std::string::npos);
  CHECK(text.find("media") == std::string::npos);
  CHECK(text.find("\"row\"") == std::string::npos);
  CHECK(text.find(R"("words":[{"text":"P1","t":1.0}])") != std::string::npos);
}

TEST_CASE("Words are replaced as wholes, the longest name first") {
  const NameTable names = {{"Mary", "A"}, {"mary  smith", "B"}, {"jörg", "C"}};
  CHECK(with_words_replaced("Mary, MARY SMITH and Rosemary's JÖRG.", names, true) == "A, B and Rosemary's C.");
  CHECK(with_words_replaced("mary Mary", names, false) == "mary A");
}

}  // namespace
}  // namespace continua
