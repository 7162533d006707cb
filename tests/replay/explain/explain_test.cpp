#include "continua/replay/explain/explain.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <vector>

#include "continua/replay/explain/explain_lines.h"
#include "continua/replay/explain/explain_term.h"
#include "continua/replay/explain/explain_text.h"
#include "continua/replay/log/run_brief.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const auto traces = fs::path(source_dir()) / "traces";

RunIndex opened(const fs::path& path) {
  auto run = RunIndex::open(path.string());
  if (!run) FAIL(run.error().text());
  return *std::move(run);
}

Json explained(const RunIndex& run, const ExplainQuestion& question) {
  const auto n = asked_record(run, question);
  if (!n) FAIL(n.error().text());
  auto told = explain(run, *n);
  if (!told) FAIL(told.error().text());
  return *std::move(told);
}

std::string error_of(const RunIndex& run, const ExplainQuestion& question) {
  const auto n = asked_record(run, question);
  REQUIRE(!n.ok());
  return n.error().sentence;
}

ExplainQuestion at(double t) { return {t, {}, {}, {}}; }
ExplainQuestion step(int number) { return {{}, number, {}, {}}; }
ExplainQuestion act(int number) { return {{}, {}, number, {}}; }
ExplainQuestion record(std::size_t n) { return {{}, {}, {}, n}; }

// The record of the input in this line of the trace.
std::size_t input_of_line(const RunIndex& run, int line) {
  for (const auto n : run.of_kind("input"))
    if ((*run.record(n))["line"] == line) return n;
  FAIL("no input is of line " << line);
  return 0;
}

std::string text(const Json& told, bool all = false) {
  ExplainTextOptions options;
  options.all = all;
  return explain_text(told, options);
}

// With n in place of the numbers of records, which every change of what is logged moves.
std::string unnumbered(const std::string& text) { return std::regex_replace(text, std::regex("#[0-9]+"), "#n"); }

std::string tree(const Json& told, std::size_t width = 200) {
  ExplainTextOptions options;
  options.width = width;
  return unnumbered(explain_tree(told, options));
}

std::vector<fs::path> approved_runs() {
  std::vector<fs::path> runs;
  for (const auto& file : fs::recursive_directory_iterator(traces))
    if (file.path().string().ends_with(".run.jsonl")) runs.push_back(file.path());
  std::sort(runs.begin(), runs.end());
  return runs;
}

void each_leaf(const Json& node, const auto& visit) {
  if (!node.contains("children")) return visit(node);
  for (const auto& child : node["children"]) each_leaf(child, visit);
}

}  // namespace

TEST_CASE("the headline tells what the avatar did and what it is due to") {
  struct Row {
    const char* run;
    ExplainQuestion question;
    const char* headline;
    int line = 0;  // of the trace, whose input is asked about instead
  };
  const auto row = GENERATE(values<Row>({
      {"paper/disambiguation",
       {},
       "At 0:01 the avatar asks “Which block do you mean? Should I take the yellow block?”, because the human "
       "said “Take the block.” (0:01): “block” may mean the yellow block, the green block or the red block."},
      {"paper/disambiguation", at(6.5),
       "At 0:05.4 the avatar asks “Should I take the red block?”, because the human made the gesture “no” (0:05) "
       "after “Take the block.” (0:01)."},
      {"paper/dialogue_gesture", act(1),
       "At 0:05.05 the avatar puts the white plate 10 cm left of and 15 cm before the table's middle, because the "
       "human said “Put it there.” (0:04) with "
       "pointing with the right hand at the place 10 cm left of and 15 cm before the table's middle (0:03.8), after "
       "“The plate.” (0:01). It was done at 0:05.05."},
      {"paper/predicate_first", act(1),
       "At 0:04 the avatar puts the white plate 10 cm left of and 15 cm before the table's middle, because the human "
       "said “The plate.” (0:04) after "
       "“Put it there.” (0:01) and pointing with the right hand at the place 10 cm left of and 15 cm before the "
       "table's middle (0:00.9). It was done at 0:04.4."},
      {"paper/one_shot_learning", act(3),
       "At 0:30.4 the avatar puts the white cup on the white plate, because the human made the gesture “two fingers” "
       "(0:30) after gesture “two fingers” (0:01), “Grasp the cup.” (0:03) and “Put on the plate.” "
       "(0:26). It was done at 0:30.4."},
      {"paper/one_shot_learning", at(27),
       "At 0:26 the avatar asks “What should I put there?”, because the human said “Put on the plate.” (0:26): "
       "the thing is left unsaid."},
      {"paper/correction.physics", act(1),
       "At 0:02.2 the avatar puts the white cup 5 cm left of and 18 cm before the table's middle, because the human "
       "said “Put the white cup "
       "there.” (0:01) with gesture “points” (0:01.2). It was given up at 0:04.1."},
      {"corner/never_engaged", at(1),
       "At 0:01 the machine refuses an input: no transition from StartState takes 'speech yes'; the human said “YES” "
       "(0:01)."},
      {"paper/region_place",
       {},
       "At 0:04.2 there is the input gesture “points”: it goes with “In that blue cup.” (0:04).",
       5},
      {"paper/disambiguation", record(2),
       "At 0:01 the human says “Take the block.”: it is taken to mean “takes …”; the avatar says “Which block do "
       "you "
       "mean? Should I take the yellow block?”; it points at the yellow block."},
      {"talk/n_best",
       {},
       "At 0:03 the avatar asks “Which cup do you mean? Should I put the knife in the white cup?”, because the human "
       "said “but the knife in the cup” (0:01): “cup” may mean the white cup or the blue cup."},
      {"paper/disambiguation", step(3),
       "At 0:03 Choose goes to Choose by the transition ‘no, the next’, step 3, because the human said “No.” (0:03) "
       "after “Take the block.” (0:01)."},
  }));
  CAPTURE(row.run);
  const auto run = opened(traces / (std::string(row.run) + ".run.jsonl"));
  const auto question = row.line > 0 ? record(input_of_line(run, row.line)) : row.question;
  CHECK(explained(run, question)["headline"] == row.headline);
}

TEST_CASE("the derivation goes from the act down to words, a gesture and a pointing") {
  CHECK(tree(explained(opened(traces / "paper/dialogue_gesture.run.jsonl"), act(1))) ==
        R"j(  put(plate, <-0.1, -0.15, 0>) : t  #n
  ├─ put(plate) : loc -> t  #n
  │  ├─ put : e -> loc -> t  ← “put” in “Put it there.” (0:04)
  │  └─ plate : e  ← “it” in “Put it there.” (0:04), what was talked about: “the plate” in “The plate.” (0:01)
  └─ <-0.1, -0.15, 0> : loc  #n  raised by pointing_to_place
     ├─ place_of : e* • loc -> loc  ← the machine itself, on “Put it there.” (0:04)
     └─ dot([], <-0.1, -0.15, 0>) : e* • loc  #n
        ├─ \z. dot(met(vec(human, right_finger, z), 0.024), z) : loc -> e* • loc  ← the machine itself, on “Put it there.” (0:04)
        └─ <-0.1, -0.15, 0> : loc  ← “there” in “Put it there.” (0:04), what was pointed at: the right hand’s pointing (0:03.8)
)j");
  CHECK_THAT(tree(explained(opened(traces / "paper/one_shot_learning.run.jsonl"), act(3))),
             Contains("raised by event_to_theme") &&
                 Contains("x : e  ← left open: it was not said, in “Put on the plate.” (0:26)") &&
                 Contains("grasp : e -> t  ← gesture “two fingers” (0:30), taught at 0:03 as "
                          "grasp(the(\\x. cup(x))) (#n)"));
  CHECK_THAT(tree(explained(opened(traces / "paper/live_composition.run.jsonl"), act(5))),
             Contains("lift(cup_blue)  one step of\n  └─ hoist(cup_blue) : t") &&
                 Contains(" as \\x: e. [grasp(x), lift(x)] (#n)"));
}

TEST_CASE(
    "the text names each slot that changed, who set it and where its value is from, and what was refused and why") {
  const auto told = unnumbered(text(explained(opened(traces / "paper/disambiguation.run.jsonl"), {})));
  for (const char* part :
       {"0:01  “Take the block.”  #n", "“the block” may be the yellow block, the green block or the red block",
        "0:01  Compose → Choose by ‘several’, without input, step 2  #n", "since lacks != null and size(seen) > 1",
        "not ‘as many as shown’, ‘the same with those’", "The stack, 1 symbol before, 5 symbols after",
        "* command \\x. grasp(x) ← meaning (#n); from “take” in “Take the block.” (0:01)",
        "as the one below: command, candidates, nouns, sure", "; gesture point(block1) #n"})
    CHECK_THAT(told, Contains(part));
  CHECK_THAT(unnumbered(text(explained(opened(traces / "paper/disambiguation.run.jsonl"), step(2)))),
             Contains("utterance “Which block do you mean? Should I take the yellow block?” #n"));
  CHECK_THAT(text(explained(opened(traces / "talk/n_best.run.jsonl"), step(1))),
             Contains("chosen (likeliest) of 2: ‘command’ 53.6 % (alternative 0), ‘command’ 46.4 % (alternative 1)"));
}

TEST_CASE("all of a long list is told when it is asked for") {
  const auto told = explained(opened(traces / "paper/disambiguation.run.jsonl"), {});
  CHECK_THAT(text(told), Contains("others (--all)"));
  CHECK_THAT(text(told, true), !Contains("--all"));
}

TEST_CASE("what a log does not have is answered by what it has") {
  const auto run = opened(traces / "paper/disambiguation.run.jsonl");
  CHECK(error_of(run, step(99)) == "there is no step 99; the log has steps 1 to 9");
  CHECK(error_of(run, act(2)) == "there is no act 2; the log has act 1 alone");
  CHECK_THAT(error_of(run, record(1000)), Contains("there is no record 1000; the log has records 0 to "));
  CHECK(error_of(run, at(0.5)) == "the avatar did and refused nothing until 0:00.5; the first is at 0:01");
  CHECK(error_of(opened(traces / "corner/header_only.run.jsonl"), act(1)) == "found no acts; expected act 1");
  CHECK(error_of(opened(traces / "corner/header_only.run.jsonl"), at(1)) ==
        "the avatar did and refused nothing in this log");
}

TEST_CASE("an expectation that was not met comes first, and is traced to what was found instead") {
  const ScratchFolder folder;
  auto log = small_log();
  log.add("expect", 10,
          {{"line", 9}, {"met", false}, {"expected", {{"says", "Okay."}}}, {"found", {{"says", "Which block?"}}}});
  const auto told = explained(opened(folder.write("unmet.run.jsonl", log.text())), {});
  CHECK(told["kind"] == "expect");
  CHECK(told["about"] == 6);
  CHECK(told["headline"] ==
        "At 0:10 the expectation of line 9 is not met: the avatar says “Okay.”, found “Which block?”. At "
        "0:01.5 the avatar asks "
        "“Which block?”, because the human said “Put it there.” (0:01.5).");
}

TEST_CASE("how an act went is told with its retries, its reason and what had to make room") {
  struct Row {
    const char* status;
    Json result;
    const char* sentence;
  };
  const auto row = GENERATE(values<Row>({
      {"done",
       {{"retries", {"slipped", "slipped"}}},
       "It was done at 0:09; 2 attempts had failed before: slipped; slipped."},
      {"done", {{"moved_aside", {"cup"}}}, "It was done at 0:09; cup had to make room."},
      {"unreachable", {{"reason", "too far"}}, "It failed at 0:09: unreachable, too far."},
      {"stopped", Json::object(), "It was given up at 0:09."},
  }));
  const ScratchFolder folder;
  auto log = small_log();
  const auto n = static_cast<int>(log.add("act", 8, {{"act", 2}, {"program", "lift(a)"}, {"status", "asked"}}, 13));
  log.add("act", 8.5, {{"act", 2}, {"program", "grasp(a)"}, {"status", "done"}, {"step", 1}}, n);
  const auto unended = folder.write("unended.run.jsonl", log.text());
  CHECK(explained(opened(unended), act(2))["act"]["sentence"] == "It had not ended when the log ends.");
  log.add("act", 9, {{"act", 2}, {"program", "lift(a)"}, {"status", row.status}, {"result", row.result}}, n);
  const auto told = explained(opened(folder.write("ended.run.jsonl", log.text())), act(2));
  CHECK(told["act"]["sentence"] == row.sentence);
  CHECK(told["act"]["records"].size() == 3);
}

TEST_CASE("every record of the approved runs can be explained, from an input or the run's beginning down to origins") {
  std::size_t deeds = 0, leaves = 0;
  for (const auto& path : approved_runs()) {
    const auto run = opened(path);
    for (std::size_t n = 0; n < run.size(); ++n) {
      const auto& kind = run.kind(n);
      if (kind != "utterance" && kind != "act" && kind != "refusal" && n % 29 != 0) continue;
      CAPTURE(path, n, kind);
      const auto told = explain(run, n);
      REQUIRE(told.ok());
      CHECK_FALSE(text(*told).empty());
      if (kind != "utterance" && kind != "act" && kind != "refusal") continue;
      ++deeds;
      const auto root = (*told)["chain"].back()["kind"];
      CHECK((root == "input" || run.of_kind("input").empty() || run.of_kind("input").front() > n));
      if ((*told)["derivation"].is_null()) continue;
      each_leaf((*told)["derivation"], [&](const Json& leaf) {
        ++leaves;
        INFO(compact(leaf));
        REQUIRE(leaf.contains("origin"));
        CHECK_FALSE(text_of(leaf["origin"], "text").empty());
        const auto& input = leaf["origin"]["input"];
        CHECK((leaf["origin"]["kind"] == "machine" ||
               (input.is_number() && run.kind(input.get<std::size_t>()) == "input")));
      });
    }
  }
  CHECK(deeds > 200);
  CHECK(leaves > 200);
}

TEST_CASE("a log cut anywhere, and one whose members are of other types, is explained as far as it goes") {
  const ScratchFolder folder;
  const auto whole = small_log().text();
  for (std::size_t bytes = whole.find('\n') + 1; bytes < whole.size(); bytes += 13) {
    const auto run = RunIndex::open(folder.write("cut.run.jsonl", whole.substr(0, bytes)));
    REQUIRE(run.ok());
    for (std::size_t n = 0; n < run->size(); ++n) CHECK(explain(*run, n).ok());
  }
  const std::vector<Json> wrong{nullptr, 7, -1, "text", Json::array({1, nullptr}), {{"kind", 3}}, true};
  for (const auto& path : {traces / "paper/correction.physics.run.jsonl", traces / "talk/n_best.run.jsonl",
                           traces / "paper/one_shot_learning.run.jsonl"}) {
    const auto run = opened(path);
    std::vector<Json> records;
    for (std::size_t n = 0; n < run.size(); ++n)
      if (run.kind(n) != "pose") records.push_back(*run.record(n));
    for (const char* long_text : {"scene", "machine", "phrases"}) records.front().erase(long_text);
    std::set<std::string> keys;
    for (const auto& one : records)
      for (const auto& [key, value] : one.items()) keys.insert(key);
    for (const char* key : {"kind", "n", "t", "version"}) keys.erase(key);
    std::size_t turn = 0;
    for (const auto& key : keys) {
      std::string log;
      for (std::size_t n = 0; n < records.size(); ++n) {
        auto one = records[n];
        one["n"] = n;
        if (one.contains(key)) one[key] = wrong[turn++ % wrong.size()];
        log += compact(one) + "\n";
      }
      const auto broken = opened(folder.write("broken.run.jsonl", log));
      CAPTURE(path, key);
      for (std::size_t n = turn % 19; n < broken.size(); n += 19) {
        const auto told = explain(broken, n);
        REQUIRE(told.ok());
        CHECK_FALSE(text(*told, true).empty());
      }
      for (const auto& question : {ExplainQuestion{}, at(4), step(2), act(1)})
        if (const auto n = asked_record(broken, question)) CHECK(explain(broken, *n).ok());
    }
  }
}

TEST_CASE("terms are taken apart as they are written") {
  struct Row {
    const char* term;
    std::vector<std::string> binders, elements;
    const char* head;
  };
  const auto row = GENERATE(values<Row>({
      {"put(plate, <-0.1, -0.15, 0>)", {}, {"plate", "<-0.1, -0.15, 0>"}, "put"},
      {"\\x v. put(x, v)", {"x", "v"}, {}, ""},
      {"\\x: e. \\v: loc. put(x, v)", {"x"}, {}, ""},
      {"[a, f(b, c)]", {}, {"a", "f(b, c)"}, ""},
      {"plate", {}, {}, ""},
      {"f(a) and g(b)", {}, {}, ""},
      {"call('a, (b')", {}, {"'a, (b'"}, "call"},
      {"<0.1, 0, 0>", {}, {}, ""},
      {"f(", {}, {}, ""},
      {"", {}, {}, ""},
  }));
  CAPTURE(row.term);
  const auto parts = term_parts(row.term);
  CHECK(parts.binders == row.binders);
  CHECK(parts.elements == row.elements);
  CHECK(parts.head == row.head);
}

TEST_CASE("lines are broken at words, and a number stays with its unit") {
  CHECK(wrapped("one two three", "- ", "  ", 9) == "- one two\n  three\n");
  CHECK(wrapped("said (1.0 s), then", "", "", 11) == "said\n(1.0 s),\nthen\n");
  CHECK(wrapped("“äöü” x", "", "", 7) == "“äöü” x\n");
  CHECK(wrapped("", "  ", "", 9) == "  \n");
}
