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

// An act without a word after seven words in their order; any other word, and it begins anew.
const char* lock = R"json({"machine":1,"name":"lock","start":"0","programs":{"HEAD_NOD":"t"},
  "states":{"0":{},"1":{},"2":{},"3":{},"4":{},"5":{},"6":{}},
  "transitions":[
  {"id":"one","from":"0","on":"speech one","to":"1"},
  {"id":"two","from":"1","on":"speech two","to":"2"},
  {"id":"three","from":"2","on":"speech three","to":"3"},
  {"id":"four","from":"3","on":"speech four","to":"4"},
  {"id":"five","from":"4","on":"speech five","to":"5"},
  {"id":"six","from":"5","on":"speech six","to":"6"},
  {"id":"seven","from":"6","on":"speech seven","to":"0","do":[{"act":"HEAD_NOD"}]},
  {"id":"wrong","from":["0","1","2","3","4","5","6"],"rank":-1,"to":"0",
   "on":["speech one","speech two","speech three","speech four","speech five","speech six","speech seven"]}]})json";

struct Lab {
  explicit Lab(const char* machine = trap) {
    folder.file("trap.json", machine);
    ReplayOptions options;
    options.physics = false;
    const auto path = folder.file(
        "t.trace.jsonl", "{\"kind\":\"trace\",\"version\":1,\"scene\":\"staircase\",\"machine\":\"trap.json\"}\n");
    auto loaded = Session::load(path, options);
    if (!loaded) FAIL(loaded.error().text());
    session = std::move(*loaded);
  }

  SearchSummary search(std::uint64_t seed, int runs = 300, bool guided = true) {
    SearchOptions options;
    options.seed = seed;
    options.guided = guided;
    options.enough = [left = runs]() mutable { return left-- <= 0; };
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

// By chance a conversation has seven given words in a row with a probability below 6 / 7^7, one in 137,000.
TEST_CASE("A search that goes on from what reached something new finds what needs many turns in their order") {
  Lab lab(lock);
  const auto is_found = [&](bool guided) { return !lab.search(3, 4000, guided).findings.empty(); };
  CHECK_FALSE(is_found(false));
  CHECK(is_found(true));
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
