// continua check: the verdicts on a trace with an approved run, after a change.
#include <unistd.h>

#include <functional>
#include <regex>
#include <set>
#include <sstream>

#include "continua/core/digest.h"
#include "continua/core/located_json.h"
#include "continua/replay/check/check.h"
#include "continua/replay/check/junit.h"
#include "continua/replay/check/run_check.h"
#include "continua/replay/commands/validate.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/log/run_log.h"
#include "continua/simulation/mujoco_version.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"
#include "support/standard_output.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const std::string conversation =
    R"json({"kind":"trace","version":1,"scene":"place_setting","machine":"interaction"}
{"t":1,"kind":"speech","text":"Put the knife in the blue cup.","until":1}
{"t":2,"kind":"expect","act":"put(knife, in(cup_blue))"}
{"t":3,"kind":"end"}
)json";

TraceCheck checked(const std::string& trace) {
  static const auto shelf = std::make_shared<Shelf>();
  ReplayOptions options;
  options.physics = false;
  options.shelf = shelf;
  return check_trace(trace, options);
}

// A trace and its approved run in a folder of their own.
struct Approved {
  TemporaryFolder folder;
  std::string trace = folder.file("one.trace.jsonl", conversation);
  std::string run_path = folder.at("one.run.jsonl");
  std::string run = checked(trace).run;
  Approved() { folder.file("one.run.jsonl", run); }
};

std::string replaced(std::string text, const std::string& old, const std::string& with) {
  const auto at = text.find(old);
  INFO(old);
  REQUIRE(at != std::string::npos);
  return text.replace(at, old.size(), with);
}

std::string verdict_and_reason(const TraceCheck& check) {
  return std::string(name_of(check.verdict)) + (check.reason.empty() ? "" : ": " + check.reason);
}

// The text without the names of temporary folders, and with n in place of the numbers of records.
std::string comparable(std::string text, const std::string& folder) {
  for (auto at = text.find(folder); at != std::string::npos; at = text.find(folder)) text.erase(at, folder.size() + 1);
  return std::regex_replace(text, std::regex("#[0-9]+"), "#n");
}

}  // namespace

TEST_CASE("a report for JUnit is XML whatever the names of files are") {
  const auto xml = junit_xml("s", {{"a", "b\xff\xc3\xa4\xed\xa0\x80\x1b<", ""}});
  CHECK(xml.find("b\uFFFD\u00E4\uFFFD\uFFFD\uFFFD\u241B&lt;") != std::string::npos);
}

TEST_CASE("a trace is held against the run beside it") {
  struct Case {
    const char* what;
    std::function<void(Approved&)> change;
    const char* verdict;
  };
  const auto in_run = [](const char* old, const char* with) {
    return [=](Approved& one) { one.folder.file("one.run.jsonl", replaced(one.run, old, with)); };
  };
  const auto in_trace = [](const char* old, const char* with) {
    return [=](Approved& one) { one.folder.file("one.trace.jsonl", replaced(conversation, old, with)); };
  };
  const auto without_digest_of_trace = [](Approved& one) {
    const auto end = one.run.find('\n');
    auto header = Json::parse(one.run.substr(0, end));
    header["trace"]["digest"] = nullptr;
    one.folder.file("one.run.jsonl", compact(header) + one.run.substr(end));
  };
  const Case cases[] = {
      {"nothing", [](Approved&) {}, "same"},
      {"what it was made with", in_run(R"("arch":")", R"("arch":"another )"), "same"},
      {"no decision", in_run(R"("world":"kinematic")", R"("world":"physics")"), "same decisions"},
      {"what was said", in_run(R"("text":"Okay.")", R"("text":"Well.")"),
       "changed: They part at 0:01 (A #n, B #n): A says “Well.”, B “Okay.”"},
      {"when it was said", in_run(R"("t":1.0,"cause")", R"("t":0.5,"cause")"),
       "changed: They part at 0:00.5 (A #n, B #n): reading"},
      {"another kind of record", in_run(R"("kind":"utterance")", R"("kind":"gesture")"),
       "changed: They part at 0:01 (A #n, B #n): A has gesture"},
      {"when an act ends",
       [](Approved& one) {
         const auto done = one.run.rfind("\n{\"kind\":\"act\"") + 1;
         const auto line = one.run.substr(done, one.run.find('\n', done) + 1 - done);
         std::string later = one.run;
         later.erase(done, line.size()).insert(later.rfind("{\"kind\":\"end\""), line);
         one.folder.file("one.run.jsonl", later);
       },
       "same decisions"},
      {"how an act ends",
       in_run(R"json("program":"put(knife, in(cup_blue))","status":"done")json",
              R"json("program":"put(knife, in(cup_blue))","status":"dropped")json"),
       "changed: They part at 0:01.4 (A #n, B #n): “puts the knife in the blue cup” is dropped in A, done in B"},
      {"a record fewer", in_run(R"("kind":"expect")", R"("kind":"other")"),
       "changed: They part at 0:02 (B #n): the expectation"},
      {"a record more",
       in_run(R"({"kind":"end")", "{\"kind\":\"problem\"}\n{\"kind\":\"memory\",\"t\":3}\n{\"kind\":\"end\""),
       "changed: decisions differ, and where cannot be told: one.run.jsonl:"},
      {"an act fewer",
       [](Approved& one) {
         std::string run;
         std::istringstream lines(one.run);
         for (std::string line; std::getline(lines, line);)
           if (!line.starts_with(R"({"kind":"act")") || line.find(R"("asked")") != std::string::npos)
             run += line + "\n";
         one.folder.file("one.run.jsonl", run);
       },
       "changed: decisions differ, and where cannot be told: one.run.jsonl:"},
      {"an act more", in_run(R"({"kind":"end")", "{\"kind\":\"act\",\"act\":2}\n{\"kind\":\"end\""),
       "changed: decisions differ, and where cannot be told: one.run.jsonl:"},
      {"the trace", in_trace("\"t\":3", "\"t\":4"), "stale: one.run.jsonl was made from another trace"},
      {"which trace the run was made from", without_digest_of_trace, "same decisions"},
      {"what is expected", in_trace("cup_blue))", "plate))"),
       R"json(broken: one.trace.jsonl:3: expected {"act":"put(knife, in(plate))"}, found {"act":"put(knife, in(cup_blue))"})json"},
      {"the trace is none", in_trace("\"version\":1", "\"version\":7"), "broken"},
      {"the run is cut short",
       [](Approved& one) { one.folder.file("one.run.jsonl", one.run.substr(0, one.run.rfind("{\"kind\":\"end\""))); },
       "broken"},
      {"the run is empty", [](Approved& one) { one.folder.file("one.run.jsonl", ""); }, "broken"},
      {"the run is none", [](Approved& one) { one.folder.file("one.run.jsonl", "[]\n7\n"); }, "broken"},
      {"approved twice", [](Approved& one) { one.folder.file("one.run.json", "{}"); }, "broken"},
      {"no approved run", [](Approved& one) { fs::remove(one.run_path); }, "new: no run is approved"},
  };
  for (const auto& [what, change, verdict] : cases) {
    Approved one;
    change(one);
    INFO(what);
    const auto found = comparable(verdict_and_reason(checked(one.trace)), one.folder.path().string());
    INFO(found);
    CHECK((verdict == std::string("same") ? found == verdict : found.starts_with(verdict)));
  }
}

TEST_CASE("a run that was approved by its digests is held against them") {
  Approved one;
  fs::remove(one.run_path);
  const auto approval = approval_of(one.trace, one.run, ApprovedRun{one.folder.at("one.run.json"), "{}"});
  CHECK(approval.path == one.folder.at("one.run.json"));
  struct Case {
    const char* key;
    Json value;
    const char* verdict;
  };
  const Case cases[] = {{"approved", 1, "same"},
                        {"digest", "0", "same decisions"},
                        {"trace", "0", "stale"},
                        {"approved", 2, "broken"},
                        {"counts", nullptr, "same"}};
  for (const auto& [key, value, verdict] : cases) {
    auto digests = Json::parse(approval.content);
    digests[key] = value;
    one.folder.file("one.run.json", digests.dump());
    CAPTURE(key, value.dump());
    CHECK(name_of(checked(one.trace).verdict) == std::string(verdict));
  }
  auto changed = Json::parse(approval.content);
  changed["digest"] = changed["decisions"] = "0";
  one.folder.file("one.run.json", changed.dump());
  CHECK(checked(one.trace).reason == "decisions differ; only their digest was approved");
  changed["counts"]["utterance"] = 7;
  one.folder.file("one.run.json", changed.dump());
  CHECK(checked(one.trace).reason == "1 records of utterance, approved 7");
  one.folder.file("one.run.json", "[");
  CHECK(checked(one.trace).verdict == Verdict::broken);
}

TEST_CASE("a long run is approved by its digests, and takes the place of what was there") {
  Approved one;
  std::string longer = one.run;
  const auto pose = std::string(R"({"kind":"pose","n":1,"t":1,"bodies":{}})") + "\n";
  const auto end = longer.rfind("{\"kind\":\"end\"");
  std::string poses;
  while (poses.size() < longest_approved_log) poses += pose;
  longer.insert(end, poses);
  CHECK(approval_of(one.trace, one.run, std::nullopt).path == one.run_path);
  CHECK(approval_of(one.trace, longer, std::nullopt).path == one.folder.at("one.run.json"));
  CHECK(approval_of(one.trace, longer, ApprovedRun{one.run_path, one.run}).path == one.folder.at("one.run.json"));
  one.folder.file("one.run.jsonl", longer);
  CHECK(checked(one.trace).verdict == Verdict::same_decisions);
}

TEST_CASE("the decisions of a log are those whose digest its end states") {
  const Approved one;
  RunningDigest decisions;
  DecisionOrder order;
  Json last;
  std::istringstream lines(one.run);
  for (std::string line; std::getline(lines, line);) {
    last = Json::parse(line);
    if (const auto decision = order.next(last)) decisions.add(compact(*decision));
  }
  for (const auto& outcome : order.outcomes()) decisions.add(compact(outcome));
  CHECK(decisions.text() == last["decisions"]);
}

TEST_CASE("of examples it is told how many do not hold, and which") {
  TemporaryFolder folder;
  const auto machine = folder.file("one.machine.json", R"({"machine": 1, "name": "one", "start": "a", "transitions": [
    {"id": "go", "from": "a", "on": "speech x", "to": "b"}],
    "examples": [{"input": "speech x", "ends": "b"}, {"input": "speech x", "ends": "a"}, {"input": "speech x, speech x", "ends": "a"}]})");
  CheckOptions options;
  options.paths = {machine};
  options.report = folder.at("report.json");
  CHECK(run_check(options) == exit_no);
  const auto report = Json::parse(read_file(options.report).value());
  CHECK(report["cases"][0]["sentence"] == "2 of 3 examples not true");
  CHECK(report["cases"][0]["problems"].size() == 2);
}

TEST_CASE("to approve is to write the runs that are not as they were approved") {
  TemporaryFolder folder;
  const auto fresh = folder.file("a.trace.jsonl", conversation);
  folder.file("b.trace.jsonl", replaced(conversation, "blue", "white"));  // not as it expects
  CheckOptions options;
  options.paths = {folder.path().string()};
  options.physics = false;
  options.junit = folder.at("junit.xml");
  CHECK(run_check(options) == exit_no);
  options.approve = true;
  if (!isatty(STDIN_FILENO)) {
    CHECK(run_check(options) == exit_impossible);
    CHECK_FALSE(fs::exists(folder.at("a.run.jsonl")));
  }
  options.yes = true;
  CHECK(run_check(options) == exit_no);
  CHECK(checked(fresh).verdict == Verdict::same);
  CHECK_FALSE(fs::exists(folder.at("b.run.jsonl")));
  CHECK(read_file(options.junit).value().find("tests=\"2\" failures=\"1\"") != std::string::npos);

  fs::remove(folder.at("b.trace.jsonl"));
  folder.file("a.trace.jsonl", replaced(conversation, "\"t\":3", "\"t\":4"));
  options.approve = options.yes = false;
  CHECK(run_check(options) == exit_no);  // stale
  options.approve = options.yes = true;
  CHECK(run_check(options) == exit_done);
  options.approve = options.yes = false;
  CHECK(run_check(options) == exit_done);
}

TEST_CASE("runs are approved with their documents in the nearest folder for them") {
  TemporaryFolder folder;
  const auto trace = folder.file("below/a.trace.jsonl", conversation);
  const auto run = folder.at("below/a.run.jsonl"), whole = checked(trace).run;
  const auto unused = folder.file("documents/" + std::string(32, 'a') + ".json", "{}");
  CheckOptions options;
  options.paths = {folder.path().string()};
  options.physics = false;
  options.approve = options.yes = true;
  CHECK(run_check(options) == exit_done);
  CHECK_FALSE(fs::exists(unused));
  const bool same = read_run_log(run).value() == whole;
  CHECK(same);
  CHECK(fs::file_size(run) * 2 < whole.size());
  options.approve = options.yes = false;
  CHECK(run_check(options) == exit_done);
  CHECK(checked(trace).verdict == Verdict::same);
  CHECK(run_validate({{folder.path().string()}}) == exit_done);

  const auto graph = (*Json::parse(first_line(run).value()).find("graph"))["kept"].get<std::string>();
  folder.file("documents/" + graph + ".json", "{}");
  CHECK(run_validate({{folder.path().string()}}) != exit_done);
  CHECK(checked(trace).verdict == Verdict::broken);
  fs::remove_all(folder.at("documents"));
  CHECK_THAT(checked(trace).reason, Contains("is kept in a file of its own"));
}

TEST_CASE("the shards of a check, merged, are the check that is not shared") {
  TemporaryFolder folder;
  for (const char* name : {"a", "b", "c"}) folder.file(std::string(name) + ".trace.jsonl", conversation);
  folder.file("b.trace.jsonl", replaced(conversation, "blue", "white"));  // not as it expects
  CheckOptions options;
  options.paths = {folder.path().string()};
  options.physics = false;
  // Its output without the seconds, and the files that it writes.
  const auto outcome = [&](const CheckOptions& chosen, const std::string& name) {
    auto with_reports = chosen;
    with_reports.junit = folder.at(name + ".xml");
    with_reports.summary = folder.at(name + ".md");
    with_reports.report = folder.at(name + ".json");
    const auto [status, text] = told([&] { return run_check(with_reports); });
    const auto until = [](const std::string& all) { return all.substr(0, all.rfind("; in ")); };
    const auto summary = read_file(with_reports.summary).value();
    return std::tuple(status, until(text), read_file(with_reports.junit).value(),
                      summary.substr(summary.find("| verdict")));
  };
  const auto whole = outcome(options, "whole");
  CHECK(std::get<0>(whole) == exit_no);
  for (std::size_t index = 1; index <= 2; ++index) {
    options.shard = {index, 2};
    outcome(options, std::to_string(index));
  }
  CheckOptions merging;
  merging.merge = {folder.at("2.json"), folder.at("1.json")};
  CHECK(outcome(merging, "merged") == whole);
  merging.merge.pop_back();
  CHECK(std::get<0>(outcome(merging, "half")) == exit_impossible);
  merging.merge = {folder.at("whole.md")};
  CHECK(told([&] { return run_check(merging); }).first == exit_impossible);
}

TEST_CASE("a summary is added to what is there") {
  TemporaryFolder folder;
  CheckOptions options;
  options.paths = {folder.file("a.trace.jsonl", conversation)};
  options.physics = false;
  options.summary = folder.file("summary.md", "before\n");
  for (int i = 0; i < 2; ++i) CHECK(told([&] { return run_check(options); }).first == exit_done);
  const auto text = read_file(options.summary).value();
  CHECK(text.starts_with("before\n## continua check: all holds\n"));
  CHECK(text.find("## continua check") != text.rfind("## continua check"));
}

TEST_CASE("of a trace that fails a folder holds its run, the approved one, their diff and a page") {
  Approved one;
  one.folder.file("one.run.jsonl", replaced(one.run, R"("text":"Okay.")", R"("text":"Well.")"));
  CheckOptions options;
  options.paths = {one.trace};
  options.physics = false;
  options.github = true;
  options.failures = one.folder.at("failures");
  const auto [status, text] = told([&] { return run_check(options); });
  CHECK(status == exit_no);
  const auto in_folder = [&](const std::string& name) { return (fs::path(options.failures) / "one" / name).string(); };
  CHECK(text.find("\n     see " + in_folder("report.html") + "\n") != std::string::npos);
  // At the line of the trace whose input led to the utterance.
  CHECK(text.find("\n::error file=" + one.trace + ",line=2,title=continua check%3A changed::") != std::string::npos);
  CHECK(read_file(in_folder("one.run.jsonl")).value() == one.run);
  CHECK(read_file(in_folder("one.approved.run.jsonl")).value() == read_file(one.run_path).value());
  CHECK(Json::parse(read_file(in_folder("diff.json")).value())["same"] == false);
  CHECK(read_file(in_folder("diff.md")).value().find("Well.") != std::string::npos);
  CHECK(read_file(in_folder("report.html")).value().find("“Well.”") != std::string::npos);

  // The folder of an earlier failure goes: now nothing is approved, and an expectation is not met.
  fs::remove(one.run_path);
  one.folder.file("one.trace.jsonl", replaced(conversation, "blue", "white"));
  const auto broken = told([&] { return run_check(options); });
  CHECK(broken.first == exit_no);
  CHECK(broken.second.find(",line=3,title=continua check%3A broken::") != std::string::npos);
  std::set<std::string> files;
  for (const auto& file : fs::directory_iterator(in_folder(""))) files.insert(file.path().filename().string());
  CHECK(files == std::set<std::string>{"one.run.jsonl", "report.html"});
}

TEST_CASE("what holds leaves no folder") {
  Approved one;
  CheckOptions options;
  options.paths = {one.trace};
  options.physics = false;
  options.failures = one.folder.at("failures");
  CHECK(told([&] { return run_check(options); }).first == exit_done);
  CHECK_FALSE(fs::exists(options.failures));
  // The same decisions are a failure where the whole log is asked for, which can be approved.
  one.folder.file("one.run.jsonl", replaced(one.run, R"("continua":")", R"("continua":"0.)"));
  CHECK(told([&] { return run_check(options); }).first == exit_done);
  CHECK_FALSE(fs::exists(options.failures));
  options.strict = true;
  CHECK(told([&] { return run_check(options); }).first == exit_no);
  CHECK(fs::exists(fs::path(options.failures) / "one" / "report.html"));
  options.approve = options.yes = true;
  CHECK(told([&] { return run_check(options); }).first == exit_done);
  CHECK(read_file(one.run_path).value() == one.run);
}

TEST_CASE("JUnit's XML of what holds and what does not") {
  CHECK(junit_xml("s", {{"f", "a<b>&\"c\"", ""}, {"f", "d", "x\ny"}}) ==
        R"(<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="s" tests="2" failures="1" errors="0">
  <testsuite name="s" tests="2" failures="1" errors="0">
    <testcase classname="f" name="a&lt;b&gt;&amp;&quot;c&quot;"/>
    <testcase classname="f" name="d">
      <failure message="x
y"/>
    </testcase>
  </testsuite>
</testsuites>
)");
}

TEST_CASE("a world may have an approved run of its own") {
  Approved one;
  const auto in_world = [&](const char* world) { return find_approved_run(one.trace, world).value()->path; };
  CHECK(in_world("physics") == one.run_path);
  const auto own = one.folder.file("one.physics.run.jsonl", one.run);
  CHECK(in_world("physics") == own);
  CHECK(in_world("kinematic") == one.run_path);

  // A run approved in another world stands next to the one approved before.
  std::string elsewhere = one.run;
  const std::string kinematic = R"("world":"kinematic")";
  elsewhere.replace(elsewhere.find(kinematic), kinematic.size(), R"("world":"physics")");
  const ApprovedRun before{one.run_path, one.run};
  const auto approval = approval_of(one.trace, elsewhere, before);
  CHECK(approval.path == own);
  CHECK_FALSE(takes_place_of(approval, before));
  CHECK(approval_of(one.trace, elsewhere, approval).path == own);
  CHECK(takes_place_of({one.folder.at("one.run.json"), ""}, before));
  CHECK_FALSE(takes_place_of(before, before));
}

TEST_CASE("a version of MuJoCo may have an approved run of its own") {
  Approved one;
  const auto physics = replaced(one.run, R"("world":"kinematic")", R"("world":"physics")");
  const auto by = [&](const std::string& version) {
    return replaced(physics, fmt::format(R"("mujoco":"{}")", mujoco_version()),
                    fmt::format(R"("mujoco":"{}")", version));
  };
  const ApprovedRun before{one.folder.file("one.physics.run.jsonl", by("2.2.2")), by("2.2.2")};
  CHECK(approval_of(one.trace, by("2.2.2"), before).path == before.path);
  CHECK(approval_of(one.trace, replaced(by("3.1.0"), R"("digest":")", R"("digest":"x)"), before).path == before.path);

  const auto newer = approval_of(one.trace, by("3.1.0"), before);
  CHECK(newer.path == one.folder.at("one.physics.mujoco-3.1.0.run.jsonl"));
  CHECK_FALSE(takes_place_of(newer, before));
  one.folder.file("one.physics.mujoco-3.1.0.run.jsonl", newer.content);
  CHECK(find_approved_run(one.trace, "physics", "3.1.0").value()->path == newer.path);
  CHECK(find_approved_run(one.trace, "physics", "3.2.0").value()->path == before.path);
  CHECK(find_approved_run(one.trace, "kinematic", "3.1.0").value()->path == one.run_path);
  CHECK(approval_of(one.trace, by("3.1.0"), newer).path == newer.path);

  CHECK(other_mujocos(one.trace, before, "3.2.0") == "MuJoCo 2.2.2, 3.1.0");
  CHECK(other_mujocos(one.trace, before, "2.2.2").empty());
}
