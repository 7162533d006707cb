// Conversations that go wrong are found, and made small.
#include "continua/replay/experiment/trace_search.h"

#include <algorithm>
#include <sstream>

#include "support/catch.h"
#include "support/temporary_folder.h"

namespace continua {
namespace {

TEST_CASE("Faults of a run: three refusals in a row, an act without a word, a problem") {
  const std::string refusal = "{\"kind\":\"refusal\",\"state\":\"A\",\"input\":\"speech x\"}\n";
  const std::string human = "{\"kind\":\"input\",\"line\":2,\"event\":{\"kind\":\"speech\"}}\n";
  const std::string act = "{\"kind\":\"act\",\"program\":\"put(a, b)\",\"status\":\"asked\"}\n";
  const std::string said = "{\"kind\":\"utterance\",\"text\":\"Okay.\"}\n";
  const auto faults = [](const std::string& log) { return faults_of(log); };
  CHECK(faults(refusal + refusal + said + refusal).empty());
  CHECK(faults(refusal + refusal + refusal + refusal) == std::vector<Fault>{{"refusals", "A"}});
  CHECK(faults(human + act + said + human).empty());
  CHECK(faults(human + act + human + said) == std::vector<Fault>{{"wordless", "put"}});
  CHECK(faults("{\"kind\":\"problem\",\"message\":\"block7 fell\"}\n") ==
        std::vector<Fault>{{"problem", "block fell"}});
}

// After "come", "go" leads to a state that takes nothing. Acts are done with words, but for "nod".
const char* trap = R"json({"machine":1,"name":"trap","start":"A",
  "programs":{"HEAD_NOD":"t","HEAD_SHAKE":"t"},
  "states":{"A":{},"B":{},"Shut":{}},
  "transitions":[
  {"id":"come","from":"A","on":"speech come","to":"B"},
  {"id":"go","from":"B","on":"speech go","to":"Shut"},
  {"id":"shake","from":["A","B"],"on":"speech shake","to":"A","do":[{"act":"HEAD_SHAKE"},{"say":"There."}]},
  {"id":"nod","from":"A","on":"speech nod","to":"A","do":[{"act":"HEAD_NOD"}]}]})json";

struct Lab {
  Lab() {
    folder.file("trap.json", trap);
    ReplayOptions options;
    options.physics = false;
    const auto path = folder.file(
        "t.trace.jsonl", "{\"kind\":\"trace\",\"version\":1,\"scene\":\"staircase\",\"machine\":\"trap.json\"}\n");
    auto loaded = Session::load(path, options);
    if (!loaded) FAIL(loaded.error().text());
    session = std::move(*loaded);
  }

  SearchSummary search(std::uint64_t seed) {
    SearchOptions options;
    options.seed = seed;
    options.enough = [left = 300]() mutable { return left-- <= 0; };
    auto found = search_traces(*session, nullptr, options);
    if (!found) FAIL(found.error().text());
    return *std::move(found);
  }

  TemporaryFolder folder;
  std::optional<Session> session;
};

std::string words_in(const Trace& trace) {
  std::string words;
  for (const auto& event : trace.events)
    if (const auto* input = std::get_if<InputEvent>(&event.what)) words += input->text + " ";
  return words;
}

TEST_CASE("A search finds the dead state and the act without a word, each with the fewest turns") {
  Lab lab;
  const auto found = lab.search(1).findings;
  const auto of_kind = [&](const std::string& kind, const std::string& place) {
    const auto one = std::find_if(found.begin(), found.end(), [&](const SearchFinding& finding) {
      return finding.fault == Fault{kind, place};
    });
    return one == found.end() ? "none" : words_in(one->trace);
  };
  CHECK(of_kind("wordless", "HEAD_NOD") == "nod ");
  CHECK(of_kind("wordless", "HEAD_SHAKE") == "none");
  CHECK(of_kind("dead", "Shut") == "come go ");
  CHECK(of_kind("refusals", "Shut").starts_with("come go "));
}

TEST_CASE("The same seed finds the same") {
  Lab lab;
  const auto told = [&] {
    std::string text;
    for (const auto& one : lab.search(7).findings) text += one.fault.kind + write_trace(one.trace);
    return text;
  };
  CHECK(told() == told());
}

}  // namespace
}  // namespace continua
