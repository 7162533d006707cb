// The smallest trace that still does it: none of its events can go, and it still does it.
#include "continua/replay/experiment/shrink.h"

#include <rapidcheck.h>

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "continua/replay/commands/shrink.h"
#include "continua/replay/experiment/ddmin.h"
#include "support/catch.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

// Hears letters, one after the other: `abc` leads to Done. Names each letter that it takes, refuses the others.
const char* letters = R"json({"machine":1,"name":"letters","start":"A",
  "states":{"A":{},"B":{},"C":{},"Done":{"enter":[{"say":"Done."},{"say":"What next?"}]}},
  "transitions":[
  {"id":"a","from":"A","on":"speech a","to":"B","do":[{"say":"One."}]},
  {"id":"b","from":"B","on":"speech b","to":"C","push":{}},
  {"id":"c","from":"C","on":["speech c","speech c please"],"to":"Done"}]})json";

const std::string header = R"({"kind":"trace","version":1,"scene":"staircase","machine":"letters.json"})";

std::string speech(double t, const std::string& text) {
  return fmt::format("{{\"t\":{},\"kind\":\"speech\",\"text\":\"{}\"}}\n", t, text);
}

// A folder with the machine and a trace.
struct Lab {
  explicit Lab(const std::string& events, const std::string& head = header) {
    folder.file("letters.json", letters);
    path = folder.file("x.trace.jsonl", head + "\n" + events);
  }

  Result<Shrunk> shrunk(const std::vector<std::string>& until) {
    const auto goal = parse_goal(until);
    if (!goal) return goal.error();
    ReplayOptions options;
    options.physics = false;
    auto session = Session::load(path, options);
    if (!session) FAIL(session.error().text());
    return shrink(*session, *goal);
  }

  // The rest, in short: the lines of the trace without the header's usual fields.
  std::string left(const std::vector<std::string>& until) {
    const auto result = shrunk(until);
    if (!result) return result.error().text();
    if (!result->done) return "no: " + result->instead;
    std::string text;
    for (const auto& event : result->trace.events) {
      const auto* input = std::get_if<InputEvent>(&event.what);
      text += input ? input->text + input->name + (input->modality == Modality::pointing ? "point" : "")
                    : std::string(std::holds_alternative<Expectation>(event.what) ? "expect" : "?");
      text += fmt::format("@{} ", event.t.seconds());
    }
    return text;
  }

  TemporaryFolder folder;
  std::string path;
};

}  // namespace

TEST_CASE("ddmin finds what was planted, and asks for nothing twice") {
  const bool holds = rc::check("planted", [] {
    const auto count = *rc::gen::inRange<std::size_t>(0, 120);
    std::set<std::size_t> planted;
    for (const auto one : *rc::gen::container<std::vector<std::size_t>>(rc::gen::inRange<std::size_t>(0, 120)))
      if (one < count) planted.insert(one);
    std::set<Indices> asked;
    const auto least = ddmin(count, [&](const Indices& part) {
      RC_ASSERT(asked.insert(part).second);
      RC_ASSERT(std::is_sorted(part.begin(), part.end()));
      return std::includes(part.begin(), part.end(), planted.begin(), planted.end());
    });
    RC_ASSERT(least == Indices(planted.begin(), planted.end()));
  });
  CHECK(holds);
}

TEST_CASE("ddmin ends 1-minimal whatever it is asked for") {
  const bool holds = rc::check("any test", [] {
    const auto count = *rc::gen::inRange<std::size_t>(1, 24);
    const auto salt = *rc::gen::inRange<std::size_t>(1, 1'000'000);
    const auto test = [&](const Indices& part) {
      if (part.size() == count) return true;
      std::size_t mixed = salt;
      for (const auto index : part) mixed = mixed * 31 + index + 7;
      return mixed % 5 < 2;
    };
    const auto least = ddmin(count, test);
    RC_ASSERT(test(least));
    for (std::size_t gone = 0; gone < least.size(); ++gone) {
      auto fewer = least;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(gone));
      RC_ASSERT(!test(fewer));
    }
  });
  CHECK(holds);
}

TEST_CASE("of a trace remains what it takes") {
  Lab lab(speech(1, "x") + speech(2, "a") +
          "{\"t\":2.5,\"kind\":\"observed\",\"channel\":\"speech\",\"content\":\"hm\"}\n" +
          "{\"t\":3,\"kind\":\"expect\",\"state\":\"B\"}\n" + speech(3, "y") + speech(4, "b") +
          "{\"t\":4.5,\"kind\":\"expect\",\"state\":\"A\"}\n" + "{\"t\":4.6,\"kind\":\"pointing\",\"target\":[0,0]}\n" +
          speech(5, "c") + speech(6, "z") +
          "{\"t\":9,\"kind\":\"expect\",\"stack_depth\":7}\n{\"t\":10,\"kind\":\"end\"}\n");
  struct Row {
    std::vector<std::string> until;
    const char* left;
  };
  for (const auto& [until, left] : std::vector<Row>{
           {{"state=A"}, "expect@4.5 "},
           {{"state=B"}, "a@2 expect@3 "},
           {{"state=Done"}, "a@2 expect@3 b@4 c@5 "},
           {{"says=One."}, "a@2 expect@3 "},
           {{"says=Done."}, "a@2 expect@3 b@4 c@5 "},
           {{"says=What next?"}, "a@2 expect@3 b@4 c@5 "},
           {{"stack_depth=2"}, "a@2 expect@3 b@4 "},
           {{R"({"state":"Done","stack_depth":2})"}, "a@2 expect@3 b@4 c@5 "},
           {{"state=C", "stack_depth=2"}, "a@2 expect@3 b@4 "},
           {{"refusal"}, "x@1 expect@4.5 "},
           {{"refusal:6"}, "a@2 expect@3 y@3 "},
           {{"unmet"}, "a@2 expect@3 b@4 expect@4.5 "},
           {{"unmet:8"}, "a@2 expect@3 b@4 expect@4.5 "},
           {{"unmet:12"}, "a@2 expect@3 b@4 expect@9 "},
           {{"state=C", "says=Done."},
            "no: it ends in the state Done, having said \"One.\", \"Done.\", \"What next?\""},
           {{"problem"}, "no: it ends in the state Done, having said \"One.\", \"Done.\", \"What next?\""}}) {
    INFO(until.front());
    CHECK(lab.left(until) == left);
  }
}

TEST_CASE("what is left says no more than it must") {
  Lab lab(
      "{\"t\":1,\"kind\":\"speech\",\"text\":\"q\",\"confidence\":0.5,\"alternatives\":[{\"text\":\"r\",\"confidence\":"
      "0.4},"
      "{\"text\":\"a\",\"confidence\":0.3},{\"text\":\"s\",\"confidence\":0.2}]}\n" +
          speech(2, "b") +
          "{\"t\":3,\"kind\":\"speech\",\"text\":\"c please\",\"words\":[{\"text\":\"c\",\"t\":3},"
          "{\"text\":\"please\",\"t\":3.5}]}\n",
      R"({"kind":"trace","version":1,"scene":"staircase","machine":"letters.json","objects":{"block1":null,"block3":{"yaw":1}}})");
  const auto shrunk = lab.shrunk({"state=Done"});
  REQUIRE(shrunk.ok());
  REQUIRE(shrunk->done);
  CHECK(write_trace(shrunk->trace) ==
        "{\"kind\":\"trace\",\"version\":1,\"scene\":\"staircase\",\"machine\":\"letters.json\",\"seed\":0,"
        "\"perspective\":\"human\"}\n"
        "{\"t\":1.0,\"kind\":\"speech\",\"text\":\"q\",\"confidence\":0.5,\"alternatives\":[{\"text\":\"a\","
        "\"confidence\":0.3}]}\n"
        "{\"t\":2.0,\"kind\":\"speech\",\"text\":\"b\"}\n"
        "{\"t\":3.0,\"kind\":\"speech\",\"text\":\"c\",\"words\":[{\"text\":\"c\",\"t\":3.0}]}\n");
}

TEST_CASE("what remains of a changed run still differs from the approved one for the same reason") {
  Lab lab(speech(1, "x") + speech(2, "a") + speech(3, "y") + speech(4, "b") + speech(5, "c") + speech(6, "z"));
  ShrinkCommandOptions options;
  options.trace = lab.path;
  options.until = {"changed"};
  options.output = lab.folder.at("small.trace.jsonl");
  options.replay.physics = false;
  CHECK(run_shrink(options) == exit_impossible);  // no approved run
  const auto run_to = [&](const std::string& name) {
    auto session = Session::load(lab.path, options.replay);
    REQUIRE(session.ok());
    std::ofstream file(lab.folder.at(name), std::ios::binary);
    session->run(file);
  };
  run_to("x.run.jsonl");
  CHECK(run_shrink(options) == exit_no);
  const auto remains = [&] {
    CHECK(run_shrink(options) == exit_done);
    std::string words;
    const auto trace = read_trace(options.output);
    REQUIRE(trace.ok());
    for (const auto& event : trace->events) words += std::get<InputEvent>(event.what).text + " ";
    return words;
  };

  // Another machine: both are replayed.
  std::string edited = letters;
  edited.replace(edited.find("push"), 4, "rewrite");
  lab.folder.file("letters.json", edited);
  CHECK(remains() == "a b ");

  // Another trace: its part before the difference stays.
  lab.folder.file("letters.json", letters);
  options.against =
      lab.folder.file("other.trace.jsonl", header + "\n" + speech(1, "x") + speech(2, "a") + speech(4, "b"));
  CHECK(remains().starts_with("x a "));
  options.against = lab.folder.file("none.jsonl", "{}\n");
  CHECK(run_shrink(options) == exit_impossible);
}

TEST_CASE("what a goal cannot be is told") {
  Lab lab(speech(1, "a") + "{\"t\":2,\"kind\":\"expect\",\"state\":\"A\"}\n");
  struct Row {
    std::vector<std::string> until;
    const char* told;
  };
  for (const auto& [until, told] :
       std::vector<Row>{{{"stat=A"}, "(did you mean 'state'?)"},
                        {{"unmett"}, "(did you mean 'unmet'?)"},
                        {{""}, "expected FIELD=VALUE"},
                        {{"state=Dome"}, "the machine letters has no state 'Dome' (did you mean 'Done'?)"},
                        {{"stack_depth=deep"}, "--until: 'stack_depth' of expect"},
                        {{"state=A", "state=B"}, "twice"},
                        {{"unmet", "state=A"}, "expected it alone"},
                        {{"unmet:x"}, "expected unmet:LINE"},
                        {{"changed:4"}, "refusal, problem or changed"},
                        {{"unmet:2"}, "x.trace.jsonl:2 is no expectation of the trace"},
                        {{"refusal:3"}, "x.trace.jsonl:3 is no event of the trace"},
                        {{"{\"state\""}, "not valid JSON"},
                        {{"{}"}, "expected FIELD=VALUE"}}) {
    INFO(until.front());
    const auto result = lab.shrunk(until);
    REQUIRE_FALSE(result.ok());
    CHECK(result.error().text().find(told) != std::string::npos);
  }
}

TEST_CASE("of two hundred events the one that counts is found in a few probes") {
  std::string events;
  for (int i = 0; i < 200; ++i) events += speech(i, i == 137 ? "a" : "x");
  const auto shrunk = Lab(events).shrunk({"state=B"});
  REQUIRE(shrunk.ok());
  CHECK(shrunk->events_before == 200);
  CHECK(shrunk->events == 1);
  CHECK(shrunk->trace.events.front().line == 139);
  CHECK(shrunk->probes < 40);
}

TEST_CASE("in a trace with planted events, these remain") {
  const bool holds = rc::check("planted", [] {
    const auto count = *rc::gen::inRange(3, 40);
    auto at = *rc::gen::container<std::set<int>>(3, rc::gen::inRange(0, count));
    std::string events, planted;
    const std::string abc = "abc";
    for (int i = 0; i < count; ++i) {
      const auto rank = static_cast<std::size_t>(std::distance(at.begin(), at.lower_bound(i)));
      const bool one = at.contains(i);
      events += speech(i, one ? std::string(1, abc[rank]) : *rc::gen::element<std::string>("x", "y z", "please"));
      if (one) planted += fmt::format("{}@{} ", abc[rank], static_cast<double>(i));
    }
    RC_ASSERT(Lab(events).left({"state=Done"}) == planted);
  });
  CHECK(holds);
}

TEST_CASE("of the paper's examples remains a trace that still does it, and of which no event can go") {
  const fs::path folder = fs::path(source_dir()) / "traces/paper";
  for (const std::string name :
       {"correction", "dialogue_gesture", "disambiguation", "never_mind", "one_shot_learning"}) {
    CAPTURE(name);
    ReplayOptions options;
    options.physics = false;
    auto session = Session::load((folder / (name + ".trace.jsonl")).string(), options);
    REQUIRE(session.ok());
    const auto events = session->trace().events();
    REQUIRE(events.ok());
    std::vector<Expectation> expected;
    for (const auto& event : *events)
      if (const auto* one = std::get_if<Expectation>(&event.what)) expected.push_back(*one);
    REQUIRE_FALSE(expected.empty());
    ShrinkGoal goal;
    goal.situation = expected.back();
    const auto shrunk = shrink(*session, goal);
    REQUIRE(shrunk.ok());
    REQUIRE(shrunk->done);
    CHECK(shrunk->events <= shrunk->events_before);
    const auto does_it = [&](const Trace& trace) {
      bool met = false;
      std::ostringstream log;
      CHECK(session
                ->run(
                    trace, [&](const Situation& now) { return met = meets(expected.back(), now); }, log)
                .ok());
      return met;
    };
    const auto written = read_trace_text(write_trace(shrunk->trace), session->trace().head().name);
    REQUIRE(written.ok());
    CHECK(does_it(*written));
    for (std::size_t gone = 0; gone < written->events.size(); ++gone) {
      if (std::holds_alternative<Expectation>(written->events[gone].what)) continue;
      auto fewer = *written;
      fewer.events.erase(fewer.events.begin() + static_cast<std::ptrdiff_t>(gone));
      CHECK_FALSE(does_it(fewer));
    }
  }
}

TEST_CASE("the command writes the trace, also in another folder, and says no where it is not done") {
  const Lab lab(speech(1, "x") + speech(2, "a"));
  fs::create_directories(lab.folder.at("deep"));
  ShrinkCommandOptions options;
  options.trace = lab.path;
  options.replay.physics = false;
  options.until = {"state=B"};
  options.output = lab.folder.at("deep/small.trace.jsonl");
  CHECK(run_shrink(options) == exit_done);
  CHECK(read_file(options.output).value() ==
        "{\"kind\":\"trace\",\"version\":1,\"scene\":\"staircase\",\"machine\":\"../letters.json\",\"seed\":0,"
        "\"perspective\":\"human\"}\n{\"t\":2.0,\"kind\":\"speech\",\"text\":\"a\"}\n");
  CHECK(Session::load(options.output, options.replay).ok());
  options.until = {"state=C"};
  CHECK(run_shrink(options) == exit_no);
  options.until = {"state=Z"};
  CHECK(run_shrink(options) == exit_impossible);
  options.output = lab.path;
  options.until = {"state=B"};
  CHECK(run_shrink(options) == exit_impossible);
}
