// Counts of episodes, and their tables.
#include "continua/replay/score/score.h"

#include "continua/replay/score/score_report.h"
#include "support/catch.h"

using namespace continua;

namespace {

using Moves = std::vector<AvatarMove>;

const Blanks blanks{{"block1", "block2", "red", "black"}};

AvatarMove say(const std::string& words) { return {"speech", words}; }
AvatarMove act(const std::string& term) { return {"action", term}; }
AvatarMove gesture(const std::string& term) { return {"gesture", term}; }

Episode episode(Moves observed, Moves produced, bool sample = false) {
  Episode one{SimTime::from_seconds(1.5), 7, 3, sample ? "pointing" : "speech yes", sample, observed, produced, {}};
  one.level = agreement(observed, produced, blanks);
  return one;
}

Score score_of(const std::vector<Episode>& episodes) {
  Score score;
  for (const auto& one : episodes) score.add(one);
  return score;
}

std::string kind(const Moves& observed) { return kind_of(episode(observed, {}), blanks); }

const auto exact = episode({say("Hello.")}, {say("Hello.")});
const auto lax = episode({act("put(block1, <0.1, 0, 0>)")}, {act("put(block1, part('left', <0, 0, 0>))")});
const auto same_template = episode({say("The red block?")}, {say("The black block?")});
const auto missing = episode({say("Yes?")}, {});
const auto spurious = episode({}, {say("Yes?")});
const auto silence = episode({}, {});
const auto silent_sample = episode({}, {}, true);
const auto loud_sample = episode({}, {gesture("look_at(block1)")}, true);
const auto answered_sample = episode({say("Hello.")}, {say("Hello.")}, true);
const auto missed_sample = episode({say("Hello.")}, {}, true);

const std::vector all = {exact,   lax,           same_template, missing,         spurious,
                         silence, silent_sample, loud_sample,   answered_sample, missed_sample};

TraceScore scored(const std::string& name, const std::string& run, const std::vector<Episode>& episodes) {
  TraceScore score{name, "some traces/" + name + ".jsonl", run, {}, {}, {}};
  for (const auto& one : episodes) score.add(one, blanks);
  return score;
}

}  // namespace

TEST_CASE("episodes are counted, each level with those before it") {
  const auto score = score_of(all);
  CHECK(score.inputs == 6);
  CHECK(score.speaking == 6);
  CHECK(score.exact == 2);
  CHECK(score.lax == 3);
  CHECK(score.same_template == 4);
  CHECK(score.answered == 5);
  CHECK(score.spurious == 1);
  CHECK(score.right == 3);
  CHECK(score.samples == 2);
  CHECK(score.silent_samples == 1);
}

TEST_CASE("scores add up") {
  auto twice = score_of(all);
  twice.add(score_of(all));
  auto doubled = all;
  doubled.insert(doubled.end(), all.begin(), all.end());
  const auto expected = score_of(doubled);
  CHECK(twice.inputs == expected.inputs);
  CHECK(twice.speaking == expected.speaking);
  CHECK(twice.exact == expected.exact);
  CHECK(twice.lax == expected.lax);
  CHECK(twice.same_template == expected.same_template);
  CHECK(twice.answered == expected.answered);
  CHECK(twice.spurious == expected.spurious);
  CHECK(twice.right == expected.right);
  CHECK(twice.samples == expected.samples);
  CHECK(twice.silent_samples == expected.silent_samples);
}

TEST_CASE("F1 weighs what is missing and what is too much") {
  CHECK(score_of({}).f1() == 1);
  CHECK(score_of({silence, silent_sample}).f1() == 1);
  CHECK(score_of({exact, lax}).f1() == 1);
  CHECK(score_of({exact, missing}).f1() == Approx(2.0 / 3));
  CHECK(score_of({exact, spurious}).f1() == Approx(2.0 / 3));
  // A wrong answer counts as missing and as spurious.
  CHECK(score_of({exact, same_template}).f1() == Approx(2.0 / 4));
  CHECK(score_of({exact, loud_sample}).f1() == 1);
  CHECK(score_of({exact, missed_sample}).f1() == Approx(2.0 / 3));
  CHECK(score_of({missing}).f1() == 0);
  // 2TP / (2TP + FN + FP) of all: TP 3, FN 3, FP 2.
  CHECK(score_of(all).f1() == Approx(6.0 / 11));
}

TEST_CASE("a kind is the template of what tells most") {
  CHECK(kind({say("The red block?"), gesture("look_at(block1)")}) == "The _ block?");
  CHECK(kind({gesture("look_at(block1)"), say("The red block?"), say("Yes?")}) == "The _ block?");
  CHECK(kind({say("OK."), gesture("reach(block1)"), act("put(block1, <0, 0, 0>)"), act("lift(block1)")}) ==
        "put(_, _)");
  CHECK(kind({act("slide(block1, on(block2))")}) == "slide(_, on(_))");
  CHECK(kind({gesture("reach(block1)"), gesture("look_at(block1)")}) == "reach");
  CHECK(kind({gesture("nod")}) == "nod");
  CHECK(kind({act("push right high")}) == "push right high");
  CHECK(kind({}).empty());
}

TEST_CASE("misses are what does not agree, moves of a sample too") {
  const auto trace = scored("a", "", all);
  REQUIRE(trace.misses.size() == 5);
  CHECK(trace.misses[0].produced[0].content == "The black block?");
  CHECK(trace.misses[1].produced.empty());
  CHECK(trace.misses[2].observed.empty());
  CHECK(trace.misses[3].sample);
  CHECK(trace.misses[4].sample);
  REQUIRE(trace.kinds.size() == 4);
  CHECK(trace.kinds.at("Hello.").speaking == 3);
  CHECK(trace.kinds.at("Hello.").lax == 2);
  CHECK(trace.kinds.at("put(_, _)").exact == 0);
  CHECK(trace.kinds.at("put(_, _)").lax == 1);
}

TEST_CASE("scores are told as tables, with what to look at") {
  const ScoreReport report{"free",
                           {scored("first", "runs/first one.run.jsonl", all), scored("an empty one", "", {silence})}};
  CHECK(score_text(report, false) ==
        R"(trace         speaking      exact        lax   template     F1  spurious  inputs right  silent on pointing
first                6  2  33.3 %  3  50.0 %  4  66.7 %  0.545         1     3  50.0 %              1 of 2
an empty one         0  0       –  0       –  0       –      –         0     1 100.0 %              0 of 0
total                6  2  33.3 %  3  50.0 %  4  66.7 %  0.545         1     4  57.1 %              1 of 2

kind of move  speaking        lax
Hello.               3  2  66.7 %
The _ block?         1  0   0.0 %
Yes?                 1  0   0.0 %
put(_, _)            1  1 100.0 %

Misses
some traces/first.jsonl:3  0:01.5  speech yes
  observed: “The red block?”
  came out: “The black block?” (same template)
  continua explain 'runs/first one.run.jsonl' --record 7
some traces/first.jsonl:3  0:01.5  speech yes
  observed: “Yes?”
  came out: silence
  continua explain 'runs/first one.run.jsonl' --record 7
some traces/first.jsonl:3  0:01.5  speech yes
  observed: silence
  came out: “Yes?”
  continua explain 'runs/first one.run.jsonl' --record 7
some traces/first.jsonl:3  0:01.5  pointing
  observed: silence
  came out: gesture look_at(block1)
  continua explain 'runs/first one.run.jsonl' --record 7
some traces/first.jsonl:3  0:01.5  pointing
  observed: “Hello.”
  came out: silence
  continua explain 'runs/first one.run.jsonl' --record 7
)");
}

TEST_CASE("of the misses of a trace the first five are told, or all") {
  const ScoreReport report{"free",
                           {scored("a", "", std::vector(7, missing)), scored("b", "", std::vector(6, missing))}};
  const auto count = [](const std::string& text, const std::string& what) {
    int found = 0;
    for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
  };
  const auto few = score_text(report, false), everything = score_text(report, true);
  CHECK(count(few, "  record 7\n") == 10);
  CHECK(few.find("some traces/a.jsonl: 2 more misses; --misses tells all\n") != std::string::npos);
  CHECK(few.find("some traces/b.jsonl: 1 more miss; --misses tells all\n") != std::string::npos);
  CHECK(count(everything, "  record 7\n") == 13);
  CHECK(everything.find("--misses") == std::string::npos);
  CHECK(score_text({"free", {scored("a", "", {exact})}}, false).find("Misses") == std::string::npos);
}

TEST_CASE("scores are told as JSON") {
  const ScoreReport report{
      "world", {scored("a", "runs/a.run.jsonl", {exact, same_template}), scored("b", "", {exact, spurious})}};
  CHECK(score_json(report) == Json::parse(R"json({
    "variant": "world",
    "traces": [
      {"trace": "a", "run": "runs/a.run.jsonl", "inputs": 2, "speaking": 2, "exact": 1, "lax": 1, "template": 2,
       "answered": 2, "spurious": 0, "right": 1, "f1": 0.5, "samples": 0, "silent_samples": 0,
       "kinds": [{"kind": "Hello.", "speaking": 1, "exact": 1, "lax": 1, "template": 1},
                 {"kind": "The _ block?", "speaking": 1, "exact": 0, "lax": 0, "template": 1}],
       "misses": [{"t": 1.5, "line": 3, "record": 7, "input": "speech yes",
                   "observed": [{"channel": "speech", "content": "The red block?"}],
                   "produced": [{"channel": "speech", "content": "The black block?"}], "level": "template"}]},
      {"trace": "b", "run": null, "inputs": 2, "speaking": 1, "exact": 1, "lax": 1, "template": 1,
       "answered": 2, "spurious": 1, "right": 1, "f1": 0.6666666666666666, "samples": 0, "silent_samples": 0,
       "kinds": [{"kind": "Hello.", "speaking": 1, "exact": 1, "lax": 1, "template": 1}],
       "misses": [{"t": 1.5, "line": 3, "record": 7, "input": "speech yes", "observed": [],
                   "produced": [{"channel": "speech", "content": "Yes?"}], "level": "none"}]}],
    "total": {"inputs": 4, "speaking": 3, "exact": 2, "lax": 2, "template": 3, "answered": 4, "spurious": 1,
              "right": 2, "f1": 0.5714285714285714, "samples": 0, "silent_samples": 0},
    "kinds": [{"kind": "Hello.", "speaking": 2, "exact": 2, "lax": 2, "template": 2},
              {"kind": "The _ block?", "speaking": 1, "exact": 0, "lax": 0, "template": 1}]})json"));
}

TEST_CASE("scores are told as Markdown, without misses") {
  const auto odd = episode({say("This | that?")}, {});
  CHECK(score_markdown({"free", {scored("a", "", {exact, odd})}}) ==
        R"(| trace | speaking | exact | lax | template | F1 | spurious | inputs right | silent on pointing |
| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |
| a | 2 | 1  50.0 % | 1  50.0 % | 1  50.0 % | 0.667 | 0 | 1  50.0 % | 0 of 0 |
| total | 2 | 1  50.0 % | 1  50.0 % | 1  50.0 % | 0.667 | 0 | 1  50.0 % | 0 of 0 |

| kind of move | speaking | lax |
| --- | ---: | ---: |
| Hello. | 1 | 1 100.0 % |
| This \| that? | 1 | 0   0.0 % |
)");
}
