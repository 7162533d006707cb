// The report of a check: its lines and totals, GitHub's annotations and summary, and shards put together again.
#include "continua/replay/check/check_report.h"

#include <algorithm>
#include <random>

#include <rapidcheck.h>

#include "continua/replay/check/annotations.h"
#include "continua/replay/check/check_items.h"
#include "continua/replay/check/check_summary.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;

namespace {

CheckCase trace_case(const std::string& path, const std::string& verdict, int status, const std::string& sentence) {
  CheckCase one;
  one.path = path;
  one.is_trace = true;
  one.verdict = verdict;
  one.sentence = sentence;
  one.status = status;
  return one;
}

CheckReport some_report() {
  CheckReport report{{1, 1}, 5, {0, 1, 2, 3, 4}, 1.26, {}};
  report.cases = {
      trace_case("a.trace.jsonl", "same", exit_done, "1 expectation, same"),
      trace_case("b.trace.jsonl", "changed", exit_no, "changed: 50 % of <b>\nit"),
      trace_case("c.trace.jsonl", "same", exit_done, "2 expectations, same"),
      {"words", false, "not true", "1 of 2 examples not true", exit_no, 0, {{"words/a.json:3:7", "no"}}, "", ""},
      {"m.json", false, "true", "3 examples", exit_done, 0, {}, "", ""}};
  report.cases[1].line = 4;
  report.cases[1].details = "| a | b |\n";
  report.cases[1].page = "check-failures/b/report.html";
  return report;
}

}  // namespace

TEST_CASE("GitHub's workflow commands need some characters escaped") {
  struct Case {
    const char* text;
    const char* message;
    const char* property;
  };
  const Case cases[] = {
      {"", "", ""},
      {"plain text; a=b", "plain text; a=b", "plain text; a=b"},
      {"100 %", "100 %25", "100 %25"},
      {"%0A", "%250A", "%250A"},
      {"a\nb\r\n", "a%0Ab%0D%0A", "a%0Ab%0D%0A"},
      {"a: b, c", "a: b, c", "a%3A b%2C c"},
      {"::error::", "::error::", "%3A%3Aerror%3A%3A"},
      {"Grüße", "Grüße", "Grüße"},
  };
  for (const auto& [text, message, property] : cases) {
    CAPTURE(text);
    CHECK(github_message(text) == message);
    CHECK(github_property(text) == property);
  }
}

TEST_CASE("a place is a file, perhaps a line, perhaps a column") {
  struct Case {
    const char* where;
    const char* file;
    std::size_t line, column;
  };
  const Case cases[] = {
      {"", "", 0, 0},         {"a.json", "a.json", 0, 0}, {"a.json:3", "a.json", 3, 0},
      {"a:3:7", "a", 3, 7},   {"C:a:3:7", "C:a", 3, 7},   {"a:b", "a:b", 0, 0},
      {"a:", "a:", 0, 0},     {":3", ":3", 0, 0},         {"a:0", "a:0", 0, 0},
      {"a:3x", "a:3x", 0, 0}, {"a:1:2:3", "a:1", 2, 3},   {"a:99999999999999999999", "a:99999999999999999999", 0, 0}};
  for (const auto& [where, file, line, column] : cases) {
    CAPTURE(where);
    const auto place = place_of(where);
    CHECK(place.file == file);
    CHECK(place.line == line);
    CHECK(place.column == column);
  }
}

TEST_CASE("what fails is an annotation where it belongs") {
  std::string lines;
  for (const auto& one : some_report().cases) lines += github_annotations(one);
  CHECK(lines ==
        "::error file=b.trace.jsonl,line=4,title=continua check%3A changed::changed: 50 %25 of <b>%0Ait\n"
        "::error file=words/a.json,line=3,col=7,title=continua check%3A not true::no\n");
}

TEST_CASE("a check is told in lines and a total") {
  const auto report = some_report();
  CHECK(line_of(report.cases[0]) == "ok   a.trace.jsonl: 1 expectation, same");
  CHECK(line_of(report.cases[3]) == "FAIL words: 1 of 2 examples not true");
  CHECK(total_of(report) == "3 traces: 2 same, 1 changed; 2 other files: 1 true, 1 not true; in 1.3 s");
  CHECK(total_of({{1, 1}, 1, {0}, 0, {report.cases[4]}}) == "1 file: 1 true; in 0.0 s");
  CHECK(total_of({{1, 1}, 0, {}, 0, {}}) == "in 0.0 s");
  CHECK(report.status() == exit_no);
}

TEST_CASE("a check's summary is Markdown") {
  CHECK(markdown_of(some_report()) == R"(## continua check: failed

3 traces: 2 same, 1 changed; 2 other files: 1 true, 1 not true; in 1.3 s

| verdict | traces | other files |
| --- | ---: | ---: |
| same | 2 | |
| changed | 1 | |
| true | | 1 |
| not true | | 1 |

<details><summary><b>b.trace.jsonl</b>: changed: 50 % of &lt;b&gt; it</summary>

| a | b |

Report: check-failures/b/report.html

</details>

<details><summary><b>words</b>: 1 of 2 examples not true</summary>

```
words/a.json:3:7: no
```

</details>

)");
}

TEST_CASE("the reports of all shards, in any order, are the report of a check that is not shared") {
  const bool holds = rc::check("shards of N merged are the whole", [] {
    const auto count = *rc::gen::inRange<std::size_t>(1, 7);
    const auto files = *rc::gen::inRange<std::size_t>(0, 20);
    CheckReport whole{{1, 1}, files, {}, 0, {}};
    for (std::size_t i = 0; i < files; ++i) {
      const bool same = *rc::gen::arbitrary<bool>();
      auto one = trace_case(std::to_string(i), same ? "same" : "changed", *rc::gen::inRange(same ? 0 : 1, 3),
                            *rc::gen::arbitrary<std::string>());
      one.is_trace = *rc::gen::arbitrary<bool>();
      one.line = *rc::gen::inRange<std::size_t>(0, 3);
      one.problems = {{"w", "s"}};
      whole.cases.push_back(one);
      whole.numbers.push_back(i);
    }
    const auto costs = *rc::gen::container<std::vector<std::uint64_t>>(files, rc::gen::inRange<std::uint64_t>(0, 9));
    std::vector<std::string> names, texts;
    for (std::size_t index = 1; index <= count; ++index) {
      CheckReport part{{index, count}, files, dealt({index, count}, costs), 0, {}};
      for (const auto file : part.numbers) part.cases.push_back(whole.cases[file]);
      names.push_back(std::to_string(index));
      texts.push_back(compact(json_of(part)));
    }
    std::shuffle(texts.begin(), texts.end(), std::mt19937(*rc::gen::arbitrary<unsigned>()));
    std::vector<CheckReport> parts;
    for (const auto& text : texts) parts.push_back(read_report(text, "r").value());
    const auto all = merged(names, parts);
    RC_ASSERT(all.problems.empty());
    RC_ASSERT(compact(json_of(all.report)) == compact(json_of(whole)));
    RC_ASSERT(all.report.status() == whole.status());
  });
  CHECK(holds);
}

TEST_CASE("shards that are missing, doubled or of another check are told") {
  const auto shard = [](std::size_t index, std::size_t count, std::size_t files) {
    CheckReport part{{index, count}, files, {}, 1, {}};
    for (std::size_t i = index - 1; i < files; i += count) {
      part.numbers.push_back(i);
      part.cases.push_back(trace_case(std::to_string(i), "same", exit_done, "same"));
    }
    return part;
  };
  struct Case {
    std::vector<CheckReport> parts;
    std::vector<std::string> problems;
    std::size_t cases;
  };
  const Case cases[] = {
      {{shard(1, 2, 3), shard(2, 2, 3)}, {}, 3},
      {{shard(2, 2, 3)}, {"--merge: shard 1/2 is missing"}, 1},
      {{shard(1, 2, 3), shard(1, 2, 3)},
       {"r1: is shard 1/2, and so is r0; expected each once", "--merge: shard 2/2 is missing"},
       2},
      {{shard(1, 2, 3), shard(2, 3, 3)},
       {"r1: is shard 2/3 of 3 files; expected one of 2 of 3 files as in r0", "--merge: shard 2/2 is missing"},
       2},
      {{shard(1, 2, 3), shard(2, 2, 4)},
       {"r1: is shard 2/2 of 4 files; expected one of 2 of 3 files as in r0", "--merge: shard 2/2 is missing"},
       2},
  };
  for (const auto& [parts, problems, count] : cases) {
    std::vector<std::string> names, found;
    for (std::size_t i = 0; i < parts.size(); ++i) names.push_back("r" + std::to_string(i));
    const auto all = merged(names, parts);
    for (const auto& problem : all.problems) found.push_back(problem.text());
    CHECK(found == problems);
    CHECK(all.report.cases.size() == count);
  }
}

TEST_CASE("what is no report of a check is an error") {
  struct Case {
    const char* text;
    const char* error;
  };
  const Case cases[] = {
      {"[]", R"(r:1:1: found no report of a check; expected "check": 1)"},
      {R"({"check": 2})", R"(r:1:1: found no report of a check; expected "check": 1)"},
      {R"({"check": 1})", R"(r:1:1: found null; expected "shard": [I, N], I from 1 to N)"},
      {R"({"check": 1, "shard": [0, 1]})", R"(r:1:23: found [0,1]; expected "shard": [I, N], I from 1 to N)"},
      {R"({"check": 1, "shard": [2, 1]})", R"(r:1:23: found [2,1]; expected "shard": [I, N], I from 1 to N)"},
      {R"({"check": 1, "shard": [1, 99999999]})",
       R"(r:1:23: found [1,99999999]; expected "shard": [I, N], I from 1 to N)"},
      {R"({"check": 1, "shard": [1, 1]})", R"(r:1:1: expected "cases": a list of what came out, file by file)"},
      {R"({"check": 1, "shard": [1, 1], "files": 1, "cases": []})",
       "r:1:52: found 0; expected 1 for shard 1/1 of 1 item"},
      {R"({"check": 1, "shard": [1, 1], "cases": [7, 8]})", "r:1:41: found 7; expected an object"},
  };
  for (const auto& [text, error] : cases) {
    CAPTURE(text);
    const auto report = read_report(text, "r");
    CHECK((report ? "" : report.error().text()) == error);
  }
  const auto odd =
      read_report(R"({"check": 1, "shard": [1, 1], "files": 1, "cases": [{"path": 7, "problems": [3, {}]}]})", "r");
  REQUIRE(odd.ok());
  CHECK(odd->status() == exit_impossible);
}

TEST_CASE("a report that says two things is not believed") {
  struct Case {
    const char* verdict;
    Json status;
  };
  for (const auto& [verdict, status] :
       {Case{"same", 256}, Case{"changed", -1}, Case{"changed", 3}, Case{"changed", 0}, Case{"not true", 0}}) {
    auto report = json_of(some_report());
    report["cases"][1]["verdict"] = verdict;
    report["cases"][1]["status"] = status;
    INFO(compact(report["cases"][1]));
    const auto read = read_report(report.dump(), "r.json");
    REQUIRE_FALSE(read.ok());
    CHECK_THAT(read.error().text(), Catch::Matchers::Contains("status"));
  }
}

TEST_CASE("a report that has a key twice is not believed") {
  auto text = json_of(some_report()).dump();
  text.replace(text.find("\"status\""), 8, "\"status\":0,\"status\"");
  const auto read = read_report(text, "r.json");
  REQUIRE_FALSE(read.ok());
  CHECK_THAT(read.error().text(), Catch::Matchers::Contains("a second time"));
}

TEST_CASE("a folder without anything to check is an error") {
  const TemporaryFolder folder;
  folder.file("letter.txt", "x");
  const auto items = items_of({folder.path().string()});
  REQUIRE_FALSE(items.ok());
  CHECK_THAT(items.error().text(), Catch::Matchers::Contains("nothing to check"));
}

TEST_CASE("each trace of a list has a name of its own") {
  const TemporaryFolder folder;
  for (const char* name : {"a/one.trace.jsonl", "b/one.trace.jsonl", "b/two.trace.jsonl", "b-one.trace.jsonl",
                           "a/one.run.jsonl", "notes.txt"})
    folder.file(name, "");
  const auto items = items_of({folder.path().string(), folder.at("b/two.trace.jsonl")});
  REQUIRE(items.ok());
  std::string names;
  auto prefix = folder.path().relative_path().string() + "-";
  std::replace(prefix.begin(), prefix.end(), '/', '-');
  for (const auto& item : *items)
    names += (item.name.starts_with(prefix) ? "…" + item.name.substr(prefix.size()) : item.name) + " ";
  CHECK(names == "…a-one …b-one …b-two b-one …b-two-2 ");
  CHECK(items_of({folder.at("nothing")}).error().sentence == "there is no such file or folder");
}
