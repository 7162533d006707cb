// Coverage of runs: of small logs, counted by hand, and of the project's traces.
#include "continua/replay/coverage/coverage_text.h"

#include <algorithm>
#include <map>
#include <optional>

#include "continua/replay/commands/coverage.h"
#include "continua/replay/coverage/coverage_phrases.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"
#include "support/folders.h"
#include "support/standard_output.h"
#include "support/temporary_folder.h"

using namespace continua;

namespace {

// Two states; `ask` and `stay` have conditions, Ask has a gate.
Json header(const std::string& digest = "d1") {
  return Json::parse(R"json({
    "version": 1,
    "machine": {"name": "two", "digest": ")json" +
                     digest + R"json(", "document": {
      "states": {"Wait": {}, "Ask": {"enter": [{"when": "x", "do": [{"phrase": "which"}]}]}},
      "transitions": [{"id": "ask", "do": [{"phrase": "well"}]}, {"id": "stay"}]}},
    "phrases": {"name": "p", "document": {"say": {
      "which": [{"when": "a", "say": ["Which {wanted(x)}?", "Which?"]}, {"say": "{all}"}],
      "well": [{"say": "Well."}],
      "never used": [{"say": "No."}]}}},
    "lexicon": {"name": "words", "digest": "l1"},
    "graph": {"start": "Wait",
      "states": [{"id": "Wait"}, {"id": "Ask", "gate": {"condition": "g", "else": "Wait", "operation": "flush"}}],
      "edges": [
        {"id": "ask", "from": "Wait", "to": "Ask", "condition": "c > 1", "operation": "push"},
        {"id": "stay", "from": "Wait", "to": "Wait", "condition": "c", "operation": "none"},
        {"id": "stay", "from": "Ask", "to": "Wait", "condition": "c", "operation": "none"},
        {"id": "go", "from": "Ask", "to": "Wait", "condition": null, "operation": "pop"}]}})json");
}

// "states Wait 2; states Ask 0; conditions ask held 1": all counts, or those of one kind.
std::string counts(MachineCoverage coverage, const std::string& wanted) {
  std::string text;
  for (const auto& item : coverage.kind(wanted).items) {
    text += (text.empty() ? "" : ", ") + item.name;
    for (const auto& more : {item.outcome, item.what})
      if (!more.empty()) text += "/" + more;
    text += " " + std::to_string(item.count);
  }
  return text;
}

Result<MachineCoverage> coverage_of_log(const LogBuilder& log) {
  const TemporaryFolder folder;
  const auto run = RunIndex::open(folder.file("one.run.jsonl", log.text()));
  REQUIRE(run.ok());
  return coverage_of(*run);
}

Json fired(const std::string& text) { return Json::parse(text); }

}  // namespace

TEST_CASE("what a log reaches is counted by the header's graph") {
  struct Case {
    const char* what;
    const char* kind;    // of the record
    const char* fields;  // of it
    const char* counted;
    const char* counts;
  };
  const Case cases[] = {
      {"no record: the start", "other", "{}", "states", "Wait 1, Ask 0"},
      {"a state that was entered", "transition", R"({"id": "ask", "to": "Ask"})", "states", "Wait 1, Ask 1"},
      {"a state that the graph does not have", "transition", R"({"to": "Elsewhere"})", "states", "Wait 1, Ask 0"},
      {"an edge for each state is one transition", "transition", R"({"id": "stay"})", "transitions",
       "ask 0, stay 1, go 0"},
      {"what fired held", "transition", R"({"id": "ask"})", "conditions",
       "ask/held/c > 1 1, ask/did not hold/c > 1 0, stay/held/c 0, stay/did not hold/c 0"},
      {"candidates held, each once", "transition",
       R"({"id": "go", "candidates": [{"id": "go"}, {"id": "stay", "alternative": 0}, {"id": "stay", "alternative": 1}],
           "refused": [{"id": "ask", "reason": "c is 1"}]})",
       "conditions", "ask/held/c > 1 0, ask/did not hold/c > 1 1, stay/held/c 1, stay/did not hold/c 0"},
      {"refusals tell too", "refusal", R"({"refused": [{"id": "stay", "reason": "not c"}]})", "conditions",
       "ask/held/c > 1 0, ask/did not hold/c > 1 0, stay/held/c 0, stay/did not hold/c 1"},
      {"gates", "transition", R"({"gates": [{"state": "Ask", "passed": true}]})", "gates",
       "Ask/passed/g 1, Ask/turned away/g 0"},
      {"a gate that turned away", "transition", R"({"gates": [{"state": "Ask", "passed": false}]})", "gates",
       "Ask/passed/g 0, Ask/turned away/g 1"},
      {"operations, those of gates included", "transition", R"({"operation": {"flush": {}}})", "operations",
       "push 0, none 0, pop 0, flush 1"},
      {"an operation that no transition has", "transition", R"({"operation": {"rewrite": {}}})", "operations",
       "push 0, none 0, pop 0, flush 0"},
      {"other branches", "branches",
       R"({"branches": [{"state": "Wait", "by": ["stay"]}, {"state": "Ask", "by": ["ask"]}, {"state": "Ask", "by": []}]})",
       "transitions", "ask 1, stay 0, go 0"},
      {"states of other branches", "branches",
       R"({"branches": [{"state": "Wait", "by": ["stay"]}, {"state": "Ask", "by": ["ask"]}, {"state": "Ask", "by": []}]})",
       "states", "Wait 1, Ask 1"},
      {"raising rules", "application", R"({"rule": "r"})", "raising rules", "r 1"},
      {"no raising rule", "application", R"({"rule": null})", "raising rules", ""},
      {"entries of the reading that was taken", "reading",
       R"({"rank": 1, "entries": [{"words": "a", "category": "N", "term": "t"}, {"words": "b", "parses": [0]},
           {"words": "c", "parses": [0, 1]}]})",
       "lexicon entries", "a/N, t 1, c/passed over 1"},
      {"a reading that was not gone on with", "reading", R"({"taken": false, "entries": [{"words": "a"}]})",
       "lexicon entries", ""},
      {"rules of the lexicon", "reading", R"({"rules": ["bare", "bare"]})", "lexicon rules", "bare 2"},
      {"members of unexpected types", "transition",
       R"({"id": 7, "to": [], "operation": 3, "candidates": {"id": "ask"}, "refused": [4, "ask"], "gates": "Ask"})",
       "conditions", "ask/held/c > 1 0, ask/did not hold/c > 1 0, stay/held/c 0, stay/did not hold/c 0"},
  };
  for (const auto& [what, kind, fields, counted, wanted] : cases) {
    LogBuilder log;
    log.add("run", 0, header());
    log.add(kind, 1, fired(fields));
    INFO(what);
    CHECK(counts(coverage_of_log(log).value(), counted) == wanted);
  }
}

TEST_CASE("an utterance is counted for the case of a phrase that it fits best") {
  struct Case {
    const char* transition;
    const char* text;
    const char* counts;
  };
  const Case cases[] = {
      {R"({"id": "ask", "to": "Ask"})", "Which cup?", "which/a 1, which/otherwise 0, well 0"},
      {R"({"id": "ask", "to": "Ask"})", "Which?", "which/a 1, which/otherwise 0, well 0"},
      {R"({"id": "ask", "to": "Ask"})", "The cup!", "which/a 0, which/otherwise 1, well 0"},
      {R"({"id": "ask", "to": "Ask"})", "Well.", "which/a 0, which/otherwise 0, well 1"},
      {R"({"id": "stay", "to": "Wait"})", "Well.", "which/a 0, which/otherwise 0, well 0"},
      {R"({"id": "stay", "to": "Ask"})", "Well.", "which/a 0, which/otherwise 1, well 0"},
  };
  for (const auto& [transition, text, wanted] : cases) {
    LogBuilder log;
    log.add("run", 0, header());
    const auto cause = log.add("transition", 1, fired(transition));
    log.add("utterance", 1, {{"text", text}}, static_cast<int>(cause));
    CAPTURE(transition, text);
    CHECK(counts(coverage_of_log(log).value(), "phrases") == wanted);
  }
}

TEST_CASE("a template fits the texts that it can make") {
  struct Case {
    const char* pattern;
    const char* text;
    std::optional<std::size_t> fit;
  };
  const Case cases[] = {
      {"Okay.", "Okay.", 5},
      {"Okay.", "Okay. ", std::nullopt},
      {"", "", 0},
      {"{x}", "anything", 0},
      {"{x}", "", 0},
      {"a{x}a", "a", std::nullopt},
      {"a{x}a", "aa", 2},
      {"Is it {wording(x)}?", "Is it the cup?", 7},
      {"Is it {wording(x)}?", "Is it the cup.", std::nullopt},
      {"{a} and {b}", "x and y and z", 5},
      {"{a} and {b}", "x or y", std::nullopt},
      {"{f('{}')}!", "x!", 1},
      {"{never closed", "x", 0},
      {"closed }", "closed }", 8},
  };
  for (const auto& [pattern, text, fit] : cases) {
    CAPTURE(pattern, text);
    CHECK(fit_of(pattern, text) == fit);
  }
}

TEST_CASE("runs of one machine are summed, those of another version are apart") {
  const auto one = [](const std::string& digest, const char* id) {
    LogBuilder log;
    log.add("run", 0, header(digest));
    log.add("transition", 1, {{"id", id}, {"to", "Ask"}});
    log.add("application", 1, {{"rule", id}});
    return coverage_of_log(log).value();
  };
  const auto machines = by_machine({one("d1", "ask"), one("d2", "go"), one("d1", "go"), one("d1", "ask")});
  REQUIRE(machines.size() == 2);
  CHECK(machines[0].runs == 3);
  CHECK(machines[1].runs == 1);
  CHECK(counts(machines[0], "states") == "Wait 3, Ask 3");
  CHECK(counts(machines[0], "transitions") == "ask 2, stay 0, go 1");
  CHECK(counts(machines[0], "raising rules") == "ask 2, go 1");
  CHECK(counts(machines[1], "transitions") == "ask 0, stay 0, go 1");
}

TEST_CASE("what can be reached comes first, in its own order, and what else was used last") {
  CoverageKind kind{"rules", {{"b", "", "", 2}, {"x", "", "", 1}}};
  add_reachable(kind, {{"c", "", "", 0}, {"b", "", "", 0}, {"a", "", "", 7}});
  MachineCoverage machine;
  machine.kinds = {kind};
  CHECK(counts(machine, "rules") == "c 0, b 2, a 0, x 1");
  CHECK(kind.reached() == 2);
}

TEST_CASE("a log without a graph cannot be counted") {
  for (const char* graph : {"null", "7", "{}", R"({"states": {}})", R"({"states": []})"}) {
    LogBuilder log;
    log.add("run", 0, {{"version", 1}, {"graph", Json::parse(graph)}});
    CAPTURE(graph);
    CHECK_FALSE(coverage_of_log(log).ok());
  }
}

TEST_CASE("coverage is told with bars, and the first few of what was never reached") {
  MachineCoverage machine{"two", "0123456789", "", "", 2, {}};
  machine.kinds = {{"states", {{"A", "", "", 3}, {"B", "", "", 0}}}, {"gates"}, {"conditions"}};
  for (int i = 0; i < 14; ++i)
    machine.kinds[2].items.push_back({"t" + std::to_string(i), "held", "c", i == 0 ? std::size_t{1} : 0});
  machine.kinds.push_back({"entries", {{"e", "", "", 1}}, true});
  CHECK(coverage_text({machine}, false) == R"(two  01234567  2 runs
  states               1 of     2   50 %  [==========          ]
  conditions           1 of    14    7 %  [=                   ]
  in all               2 of    16   12 %  [==                  ]
  entries              1 of     1  100 %  [====================]
  never reached:
  states
    B
  conditions
    t1: held; c
    t2: held; c
    t3: held; c
    t4: held; c
    t5: held; c
    t6: held; c
    t7: held; c
    t8: held; c
    t9: held; c
    t10: held; c
    t11: held; c
    t12: held; c
    and 1 more
)");
  CHECK(coverage_text({machine}, true).find("    t13: held; c\n") != std::string::npos);
  CHECK(coverage_text({machine}, true).find("more") == std::string::npos);
  machine.kinds.resize(1);
  CHECK(
      coverage_json({machine}) ==
      Json::parse(R"json({"machines": [{"name": "two", "digest": "0123456789", "lexicon": null, "runs": 2, "reached": 1,
          "of": 2, "kinds": [{"kind": "states", "reached": 1, "of": 2, "items": [{"name": "A", "count": 3},
          {"name": "B", "count": 0}]}]}]})json"));
  CHECK(percent(199, 200) == 99);
  CHECK(percent(0, 0) == 100);
}

TEST_CASE("the project's traces reach what they are there for") {
  CoverageOptions options;
  options.paths = {source_dir() + "/traces/paper", source_dir() + "/traces/mechanisms", source_dir() + "/traces/talk"};
  options.json = true;
  const auto [status, text] = told([&] { return run_coverage(options); });
  REQUIRE(status == exit_done);
  const auto found = Json::parse(text);
  std::map<std::string, Json> kinds;
  for (const auto& machine : found["machines"]) {
    CAPTURE(machine["name"]);
    CHECK(machine["reached"] <= machine["of"]);
    if (machine["name"] != "interaction") continue;
    for (const auto& kind : machine["kinds"]) kinds[kind["kind"]] = kind;
  }
  for (const char* kind :
       {"states", "transitions", "conditions", "operations", "phrases", "raising rules", "lexicon entries"}) {
    CAPTURE(kind);
    REQUIRE(kinds.contains(kind));
    CHECK(kinds[kind]["reached"] > 0);
  }
  CHECK(kinds["states"]["reached"] == kinds["states"]["of"]);
  const auto rules = read_file(source_dir() + "/engine/knowledge/raising.json").value();
  CHECK(kinds["raising rules"]["of"] == Json::parse(rules)["rules"].size());
  // The parts of a reading are the lexicon's, letter for letter; taught words follow.
  std::string taught;
  for (const auto& item : kinds["lexicon entries"]["items"]) {
    if (item["count"] == 0) taught.clear();
    if (item["count"] > 0) taught += item["name"].get<std::string>() + " " + item["what"].get<std::string>() + "; ";
  }
  CHECK(taught == "hoist NAME, 'hoist'; hoist S/NP, \\x. hoist(x); tea time NAME, 'tea time'; ");
}

TEST_CASE("of a folder, the logs that go with its traces are not counted twice") {
  const std::string trace = R"({"kind":"trace","version":1,"scene":"place_setting","machine":"interaction"})"
                            "\n";
  TemporaryFolder folder;
  LogBuilder log;
  log.add("run", 0, header());
  folder.file("a.trace.jsonl", trace);
  for (const char* name : {"a.run.jsonl", "a.physics.run.jsonl", "deeper/b.run.jsonl"}) folder.file(name, log.text());
  folder.file("deeper/notes.txt", "");
  const auto machines = [](std::vector<std::string> paths, int expected, int at_least = 0) {
    CoverageOptions options;
    options.paths = std::move(paths);
    options.json = true;
    options.jobs = 2;
    options.at_least = at_least;
    const auto [status, text] = told([&] { return run_coverage(options); });
    CHECK(status == expected);
    std::string runs;
    const auto found = Json::parse(text);
    for (const auto& machine : found["machines"])
      runs += machine["name"].get<std::string>() + " " + machine["runs"].dump() + ";";
    return runs;
  };
  CHECK(machines({folder.path().string()}, exit_done) == "interaction 1;two 1;");
  CHECK(machines({folder.at("a.run.jsonl"), folder.at("a.physics.run.jsonl")}, exit_done) == "two 2;");
  CHECK(machines({folder.at("a.trace.jsonl"), folder.at("deeper/notes.txt")}, exit_impossible) == "interaction 1;");
  CHECK(machines({folder.at("nothing")}, exit_impossible).empty());
  CHECK(machines({folder.at("a.run.jsonl")}, exit_no, 100) == "two 1;");
  TemporaryFolder empty;
  CHECK(machines({empty.path().string()}, exit_impossible).empty());
}
