// A trace as noisier recognisers would have told it.
#include "continua/replay/noise/vary.h"

#include <cmath>
#include <set>

#include <fmt/format.h>

#include "continua/replay/trace/trace_event.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

namespace continua {
namespace {

Trace trace_of(const std::string& events) {
  auto trace = read_trace_text("{\"kind\":\"trace\",\"version\":1,\"scene\":\"s\",\"machine\":\"m\"}\n" + events, "t");
  if (!trace) FAIL(trace.error().text());
  return *std::move(trace);
}

// A table of two words; a recogniser that is surer of right words.
Noise noise_of(const std::string& members) {
  TemporaryFolder folder;
  folder.file("confusions/english.json",
              R"({"confusions":1,"confidence":{"share_wrong":0.5,"right":[0.5,1],"wrong":[0,0.5]},
                  "words":{"cup":{"cap":3,"cut":1},"take":{"bake":1}}})");
  const auto noise = read_noise(folder.file("n.json", "{\"noise\":1" + members + "}"), folder.path());
  if (!noise) FAIL(noise.error().text());
  return *noise;
}

std::string many_utterances(int count, const std::string& text) {
  std::string events;
  for (int i = 1; i <= count; ++i) events += fmt::format("{{\"t\":{},\"kind\":\"speech\",\"text\":\"{}\"}}\n", i, text);
  return events;
}

Trace varied(const Trace& trace, const Noise& noise, std::uint64_t seed) {
  return edited_trace(trace, edits_of(trace, noise, seed));
}

const InputEvent& input_at(const Trace& trace, std::size_t i) { return std::get<InputEvent>(trace.events[i].what); }

TEST_CASE("Without noise a trace keeps all but its expectations") {
  const auto trace = trace_of(
      R"({"t":1,"kind":"speech","text":"take the cup"}
{"t":2,"kind":"expect","state":"Ready"}
{"t":3,"kind":"end"}
)");
  const auto same = varied(trace, {}, 0);
  CHECK(edits_of(trace, {}, 0).empty());
  REQUIRE(same.events.size() == 2);
  CHECK(write_event(same.events[0]) == R"({"t":1.0,"kind":"speech","text":"take the cup"})");
}

TEST_CASE("The same seed gives the same trace, another seed another") {
  const auto noise = noise_of(R"(,"words":{"misheard":0.3,"dropped":0.1,"swapped":0.1},"times":{"sd":0.2})");
  const auto trace = trace_of(many_utterances(30, "take the cup"));
  CHECK(write_trace(varied(trace, noise, 4)) == write_trace(varied(trace, noise, 4)));
  CHECK(write_trace(varied(trace, noise, 4)) != write_trace(varied(trace, noise, 5)));
}

TEST_CASE("A varied trace is a trace: it can be read again") {
  const auto noise = noise_of(
      R"(,"words":{"misheard":0.3,"dropped":0.3},"n_best":{"share":0.3},"times":{"sd":1},
         "gestures":{"missed":0.3,"doubled":0.3},"pointing":{"sd":0.1,"late":1,"cut":1})");
  std::string events;
  for (int i = 1; i <= 40; ++i)
    events += fmt::format(
        "{{\"t\":{0},\"kind\":\"speech\",\"text\":\"take the cup\",\"until\":{0}.9}}\n"
        "{{\"t\":{0}.2,\"kind\":\"pointing\",\"target\":[0.1,0.2]}}\n"
        "{{\"t\":{0}.4,\"kind\":\"pointing\",\"target\":[0.1,0.2]}}\n"
        "{{\"t\":{0}.5,\"kind\":\"gesture\",\"name\":\"posack\"}}\n",
        i);
  const auto trace = trace_of(events + "{\"t\":41,\"kind\":\"end\"}\n");
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto text = write_trace(varied(trace, noise, seed));
    const auto again = read_trace_text(text, "varied");
    if (!again) FAIL(again.error().text());
    CHECK(write_trace(*again) == text);
  }
}

TEST_CASE("The share of wrong words is that of the noise, and they are those of the table") {
  const auto trace = trace_of(many_utterances(2000, "cup"));
  int wrong = 0;
  const auto noisy = varied(trace, noise_of(R"(,"words":{"misheard":0.2})"), 1);
  for (std::size_t i = 0; i < noisy.events.size(); ++i) {
    const auto& text = input_at(noisy, i).text;
    CHECK(std::set<std::string>{"cup", "cap", "cut"}.count(text) == 1);
    wrong += text != "cup";
  }
  CHECK(std::abs(wrong - 400) < 60);
}

TEST_CASE("A stronger noise of the same seed changes what the weaker one changed") {
  const auto trace = trace_of(many_utterances(200, "cup"));
  const auto noise = noise_of(R"(,"words":{"misheard":0.2})");
  const auto weak = varied(trace, only(noise, "words", 0.5), 3), strong = varied(trace, only(noise, "words", 2), 3);
  int kept = 0;
  for (std::size_t i = 0; i < weak.events.size(); ++i) {
    if (input_at(weak, i).text == "cup") continue;
    CHECK(input_at(strong, i).text == input_at(weak, i).text);
    ++kept;
  }
  CHECK(kept > 5);
}

TEST_CASE("A misheard word makes an utterance less sure") {
  const auto noise = noise_of(R"(,"words":{"misheard":0.5})");
  const auto noisy = varied(trace_of(many_utterances(100, "cup")), noise, 1);
  for (std::size_t i = 0; i < noisy.events.size(); ++i) {
    const auto& input = input_at(noisy, i);
    CHECK((input.text == "cup" ? input.confidence >= 0.5 : input.confidence <= 0.5));
  }
}

TEST_CASE("Marks stay with their word, and times with words that are heard") {
  const auto noise = noise_of(R"(,"words":{"misheard":1})");
  const auto noisy =
      varied(trace_of("{\"t\":1,\"kind\":\"speech\",\"text\":\"Take cup!\",\"words\":[{\"text\":\"Take\",\"t\":1},"
                      "{\"text\":\"cup\",\"t\":1.4}]}\n"),
             noise, 0);
  const auto& input = input_at(noisy, 0);
  CHECK(input.text.starts_with("bake c"));
  CHECK(input.text.ends_with("!"));
  REQUIRE(input.words.size() == 2);
  CHECK(input.words[0].text == "bake");
  CHECK(input.words[1].t == SimTime::from_seconds(1.4));
}

TEST_CASE("A list of readings has what was said at its place, and falls in confidence") {
  const auto noise = noise_of(R"(,"n_best":{"size":4,"truth":3})");
  const auto noisy = varied(trace_of(many_utterances(50, "take cup")), noise, 2);
  for (std::size_t i = 0; i < noisy.events.size(); ++i) {
    const auto& input = input_at(noisy, i);
    REQUIRE(input.alternatives.size() == 3);
    CHECK(input.alternatives[1].text == "take cup");
    CHECK(input.text != "take cup");
    double before = input.confidence, sum = before;
    for (const auto& one : input.alternatives) {
      CHECK(one.confidence <= before);
      sum += before = one.confidence;
    }
    CHECK(sum < 1.01);
  }
}

TEST_CASE("Of a pointing that is cut the end is lost, and never the first sample") {
  std::string events;
  for (int i = 0; i < 20; ++i)
    events += fmt::format("{{\"t\":{:.1f},\"kind\":\"pointing\",\"target\":[0,0]}}\n", 1 + 0.1 * i);
  const auto trace = trace_of(events);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto noisy = varied(trace, noise_of(R"(,"pointing":{"cut":1})"), seed);
    REQUIRE(!noisy.events.empty());
    CHECK(noisy.events.front().t == SimTime::from_seconds(1));
    for (std::size_t i = 0; i < noisy.events.size(); ++i) CHECK(noisy.events[i].t == trace.events[i].t);
  }
}

TEST_CASE("Late pointing happened when it did") {
  const auto noisy =
      varied(trace_of("{\"t\":1,\"kind\":\"pointing\",\"target\":[0,0]}\n"), noise_of(R"(,"pointing":{"late":2})"), 0);
  CHECK(input_at(noisy, 0).t == SimTime::from_seconds(1));
  CHECK(noisy.events[0].t > SimTime::from_seconds(1));
}

TEST_CASE("Gestures are missed or seen twice") {
  const std::string gesture = "{\"t\":1,\"kind\":\"gesture\",\"name\":\"posack\"}\n";
  CHECK(varied(trace_of(gesture), noise_of(R"(,"gestures":{"missed":1})"), 0).events.empty());
  CHECK(varied(trace_of(gesture), noise_of(R"(,"gestures":{"doubled":1})"), 0).events.size() == 2);
}

}  // namespace
}  // namespace continua
