#include "continua/replay/live/live_events.h"

#include "continua/replay/live/live_clock.h"
#include "support/catch.h"

using namespace continua;
using Catch::Matchers::StartsWith;

namespace {

constexpr auto wall = LiveTiming::wall, by_events = LiveTiming::events;

// The lines that a body that comes at 10 s adds to a trace, or its fault.
std::string lines_of(std::string_view body, LiveTiming timing = wall) {
  const auto events = events_in(body);
  if (!events) return events.error().text();
  const auto timed = timed_events(*events, timing, SimTime::from_seconds(10), 5);
  if (!timed) return timed.error().text();
  std::string lines;
  for (const auto& one : *timed) {
    if (one.event) CHECK(one.event->t == one.t);
    lines += (lines.empty() ? "" : "\n") + (one.event ? one.line : "until " + compact(one.t.seconds()));
  }
  return lines;
}

}  // namespace

TEST_CASE("a body is one event, several in an array, or one a line") {
  const std::string a = R"({"kind":"speech","text":"a"})", b = R"({"kind":"speech","text":"b"})";
  const std::string at_10 = R"({"t":10.0,"kind":"speech","text":)";
  for (const auto& body : {a + b, std::string("[" + a), std::string(""), std::string("[]"), a + "\n{\n"})
    CHECK_THAT(lines_of(body), StartsWith("body"));
  CHECK(lines_of(a) == at_10 + "\"a\"}");
  CHECK(lines_of(" {\"kind\":\"speech\",\n\"text\":\"a\"}\n") == at_10 + "\"a\"}");
  const auto both = at_10 + "\"a\"}\n" + at_10 + "\"b\"}";
  CHECK(lines_of("[" + a + ", " + b + "]") == both);
  CHECK(lines_of(R"({"events":[)" + a + "," + b + "]}") == both);
  CHECK(lines_of(a + "\r\n\n" + b) == both);
  CHECK(lines_of(a + "\n" + b + "\n") == both);
}

TEST_CASE("each event gets its place in time, and stays as it is otherwise") {
  struct Case {
    std::string event, line;
    LiveTiming timing = wall;
  };
  const auto [event, line, timing] = GENERATE(values<Case>({
      {R"({"text":"a","kind":"speech","more":[1]})", R"({"t":10.0,"text":"a","kind":"speech","more":[1]})"},
      {R"({"t":10,"kind":"speech","text":"a"})", R"({"t":10,"kind":"speech","text":"a"})"},
      {R"({"t":10.5,"kind":"speech","text":"a"})", R"({"t":10.5,"kind":"speech","text":"a"})"},
      {R"({"t":9.25,"kind":"speech","text":"a","until":9.5})",
       R"({"t":10.0,"happened":9.25,"kind":"speech","text":"a","until":9.5})"},
      {R"({"happened":1,"kind":"speech","text":"a"})", R"({"t":10.0,"kind":"speech","text":"a"})"},
      {R"({"t":11.5,"kind":"speech","text":"a"})",
       "event: 't' is 11.5, 1.5 s ahead of the session's time; expected at most 1 s, or a session whose clock goes by "
       "events"},
      {R"({"t":500,"kind":"speech","text":"a"})", R"({"t":500,"kind":"speech","text":"a"})", by_events},
      {R"({"t":90000,"kind":"speech","text":"a"})",
       "event: 't' is 90000, 89990 s ahead of the session's time; expected at most 86400 s", by_events},
      {R"({"t":20,"kind":"clock"})", "until 20.0", by_events},
      {R"({"t":5,"kind":"clock"})", "until 10.0", by_events},
      {R"({"kind":"clock"})", "event: clock has no time 't'; expected that to which time goes on", by_events},
      {R"({"t":"now","kind":"speech","text":"a"})",
       "event: 't' of speech is 'now'; expected a number from 0 to 1000000000"},
      {R"({"t":-1,"kind":"speech","text":"a"})", "event: 't' of speech is -1; expected a number from 0 to 1000000000"},
      {R"({"kind":"speech"})", "event: speech has no 'text' or 'alternatives'"},
      {R"({"kind":"speach","text":"a"})",
       "event: unknown kind 'speach' (did you mean 'speech'?); expected speech, gesture, pointing, gaze, observed, "
       "expect, "
       "mark, end or clock"},
      {R"({"kind":"pointing","target":[1e10,0]})",
       "event: 'target' of pointing is [10000000000.0,0]; expected [x, y] in metres, each from -1000000000 to "
       "1000000000"},
      {R"(3)", "event: found '3'; expected an event as a JSON object"},
      {R"([[1]])", "event: found '[1]'; expected an event as a JSON object"},
  }));
  CHECK(lines_of(event, timing) == line);
}

TEST_CASE("no event is earlier than the one before it") {
  CHECK(lines_of(R"([{"t":10.2,"kind":"gesture","name":"a"},{"t":10.1,"kind":"gesture","name":"b"},
                     {"kind":"gesture","name":"c"}])") ==
        "{\"t\":10.2,\"kind\":\"gesture\",\"name\":\"a\"}\n"
        "{\"t\":10.2,\"happened\":10.1,\"kind\":\"gesture\",\"name\":\"b\"}\n"
        "{\"t\":10.2,\"kind\":\"gesture\",\"name\":\"c\"}");
  CHECK(lines_of(R"([{"kind":"end"},{"kind":"gesture","name":"a"}])") ==
        "event 2: found after 'end'; expected 'end' to be the last");
}

TEST_CASE("a clock shows engine time, however late it is looked at") {
  using std::chrono::seconds;
  const WallTime start;
  LiveClock clock(2);
  CHECK(clock.at(start + seconds(5)) == SimTime{});
  clock.run(start + seconds(5));
  CHECK(clock.at(start + seconds(8)).seconds() == 6);
  CHECK(clock.when(SimTime::from_seconds(6)) == start + seconds(8));
  CHECK(clock.at(start).seconds() == 0);
  clock.stop(start + seconds(8));
  CHECK(clock.at(start + seconds(20)).seconds() == 6);
  clock.run(start + seconds(20));
  CHECK(clock.at(start + seconds(21)).seconds() == 8);
  clock.set(SimTime::from_seconds(100), start + seconds(21));
  CHECK(clock.at(start + seconds(22)).seconds() == 102);
}
