#include "continua/replay/session/session.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/core/located_json.h"
#include "continua/replay/trace/session_import.h"
#include "continua/replay/trace/trace_file.h"
#include "support/catch.h"
#include "support/folders.h"
#include "support/sources.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const char* machine = R"json({
  "machine": 1, "name": "fetch", "start": "Wait", "repeat_utterances": false,
  "programs": { "put": "e -> loc -> t", "reach": "e -> t" },
  "slots": { "indicated": "e", "action": "term" },
  "define": { "nearest": "head(sort_by(scene, \\x. distance(position(x), target)))" },
  "states": { "Wait": {}, "Asked": { "enter": [ { "say": "The {attribute(indicated, 'color')} one?" }, { "gesture": "reach(indicated)" } ] },
              "Done": { "enter": [ { "say": "OK." } ] } },
  "transitions": [
    { "id": "point", "from": "*", "on": "gesture right point start", "to": "Asked", "push": { "indicated": "nearest", "action": "\\p. put(nearest, p)" } },
    { "id": "there", "from": "Asked", "on": "pointing right", "to": "Done", "do": [ { "act": "fill(action, target)" } ] } ] })json";

const char* trace = R"json({"kind":"trace","version":1,"scene":"staircase","machine":"fetch.json"}
{"t":1,"kind":"gesture","name":"point","hand":"right","phase":"start","target":[-0.1,0.05]}
{"t":1.5,"kind":"expect","state":"Asked"}
{"t":2,"kind":"pointing","hand":"right","target":[0.05,-0.06]}
{"t":2,"kind":"expect","says":"OK.","state":"Done"}
{"t":3,"kind":"speech","text":"what?"}
)json";

// A folder with a machine and a trace, gone with the test.
struct Folder {
  Folder() : path(fs::temp_directory_path() / ("continua_session_" + std::to_string(::getpid()))) {
    fs::create_directories(path);
    write("fetch.json", machine);
    write("talk.jsonl", trace);
  }
  ~Folder() { fs::remove_all(path); }
  void write(const std::string& name, const std::string& content) const { std::ofstream(path / name) << content; }
  std::string file(const std::string& name) const { return (path / name).string(); }
  fs::path path;
};

ReplayOptions kinematic() {
  ReplayOptions options;
  options.physics = false;
  return options;
}

std::string log_of(const std::string& path, const ReplayOptions& options = kinematic()) {
  std::ostringstream out;
  auto session = Session::load(path, options);
  if (!session) FAIL(session.error().text());
  session->run(out);
  return out.str();
}

std::vector<Json> records_of(const std::string& log) {
  std::vector<Json> records;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) records.push_back(Json::parse(line));
  return records;
}

std::vector<Json> of_kind(const std::vector<Json>& records, const std::string& kind) {
  std::vector<Json> found;
  for (const auto& record : records)
    if (record["kind"] == kind) found.push_back(record);
  return found;
}

}  // namespace

TEST_CASE("a replay writes what was heard, decided, said and done, each with its cause") {
  const Folder folder;
  const auto log = log_of(folder.file("talk.jsonl"));
  const auto records = records_of(log);
  REQUIRE(records.front()["kind"] == "run");
  REQUIRE(records.back()["kind"] == "end");
  std::set<int> symbols;
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto& record = records[i];
    CHECK(record["n"] == i);
    if (record.contains("cause")) CHECK(record["cause"] < record["n"]);
    if (record["kind"] == "symbol") symbols.insert(record["id"].get<int>());
    if (record.contains("stack")) CHECK(symbols.contains(record["stack"].get<int>()));
  }
  CHECK(of_kind(records, "utterance").at(0)["text"] == "The red one?");
  CHECK(of_kind(records, "utterance").at(1)["text"] == "OK.");
  const auto applied = of_kind(records, "application").back();
  CHECK(applied["result"] == "put(block6, <0.05, -0.06, 0>)");
  const auto inputs = of_kind(records, "input");
  CHECK(inputs_behind(records, applied) == std::set<std::size_t>{inputs.at(0)["n"], inputs.at(1)["n"]});
  const auto acts = of_kind(records, "act");
  CHECK(acts.front()["status"] == "asked");
  CHECK(acts.back()["status"] == "done");
  CHECK(of_kind(records, "refusal").size() == 1);
  CHECK(of_kind(records, "expect").size() == 2);
  const auto before_end = log.substr(0, log.rfind("{\"kind\":\"end\""));
  CHECK(records.back()["digest"] == digest(before_end));
}

TEST_CASE("an act is told with the steps that the body does, which come of it") {
  const Folder folder;
  const auto records = records_of(log_of(folder.file("talk.jsonl")));
  std::vector<std::string> told;
  int asked = -1;
  for (const auto& act : of_kind(records, "act")) {
    told.push_back((act.contains("step") ? act["step"].dump() + " " : std::string()) +
                   act["program"].get<std::string>() + " " + act["status"].get<std::string>());
    CHECK(act["act"] == 1);
    if (asked < 0)
      asked = act["n"].get<int>();
    else
      CHECK(act["cause"] == asked);
  }
  const std::string goal = "(block6, <0.05, -0.06, 0>)";
  CHECK(told == std::vector<std::string>{"put" + goal + " asked", "put" + goal + " started", "1 grasp(block6) started",
                                         "1 grasp(block6) done", "2 move" + goal + " started",
                                         "2 move" + goal + " done", "3 ungrasp(block6) started",
                                         "3 ungrasp(block6) done", "put" + goal + " done"});
}

TEST_CASE("the end of an act is an input where the machine knows it, and decisions are the same in both worlds") {
  const Folder folder;
  auto told = Json::parse(machine);
  told["transitions"].push_back(Json::parse(
      R"json({ "id": "told", "from": "Done", "on": "act done", "to": "Wait", "do": [ { "say": "I did {act}." } ] })json"));
  folder.write("fetch.json", told.dump());
  folder.write("told.jsonl", R"json({"kind":"trace","version":1,"scene":"staircase","machine":"fetch.json"}
{"t":1,"kind":"gesture","name":"point","hand":"right","phase":"start","target":[-0.1,0.05]}
{"t":2,"kind":"pointing","hand":"right","target":[0.05,-0.06]}
{"t":40,"kind":"expect","state":"Wait"}
)json");
  const auto kinematic_run = records_of(log_of(folder.file("told.jsonl")));
  const auto physical_run = records_of(log_of(folder.file("told.jsonl"), {}));
  CHECK(of_kind(kinematic_run, "expect").back()["met"] == true);
  CHECK(kinematic_run.back()["decisions"] == physical_run.back()["decisions"]);

  const auto inputs = of_kind(physical_run, "input");
  const auto act = *std::find_if(inputs.begin(), inputs.end(), [](const Json& one) { return one["line"].is_null(); });
  CHECK(act["symbol"] == "act done");
  CHECK(act["event"]["program"] == "put(block6, <0.05, -0.06, 0>)");
  CHECK(physical_run.at(act["cause"].get<std::size_t>())["status"] == "done");
  CHECK(of_kind(physical_run, "utterance").back()["text"] == "I did put(block6, <0.05, -0.06, 0>).");
}

TEST_CASE("the same trace gives the same bytes, in either world") {
  const Folder folder;
  CHECK(log_of(folder.file("talk.jsonl")) == log_of(folder.file("talk.jsonl")));
  CHECK(log_of(folder.file("talk.jsonl"), {}) == log_of(folder.file("talk.jsonl"), {}));
}

TEST_CASE("with physics the object comes to lie where it was put, and the act says how near") {
  const Folder folder;
  const auto records = records_of(log_of(folder.file("talk.jsonl"), {}));
  const auto acts = of_kind(records, "act");
  REQUIRE(acts.back()["status"] == "done");
  CHECK(acts.back()["result"]["position_error_m"] < 0.02);
  CHECK_FALSE(of_kind(records, "pose").empty());
  CHECK_FALSE(of_kind(records, "rest").empty());
}

TEST_CASE("a run can be given up while nothing but physics happens, and being asked changes nothing") {
  const Folder folder;
  const auto log_with = [&](std::function<bool()> give_up) {
    ReplayOptions options;
    options.give_up = std::move(give_up);
    auto session = Session::load(folder.file("talk.jsonl"), options);
    REQUIRE(session.ok());
    std::ostringstream log;
    session->run(log);
    return log.str();
  };
  const auto plain = log_with({});
  int asked = 0;
  CHECK(log_with([&] { return ++asked < 0; }) == plain);
  CHECK(asked > 5);  // several times a second while the arm moves
  int left = asked / 2;
  const auto cut = log_with([&] { return --left < 0; });
  CHECK(cut.size() < plain.size());
  CHECK(left == -1);
}

TEST_CASE("an expectation that is not met is counted and logged with what there was") {
  const Folder folder;
  folder.write("unmet.jsonl",
               std::string(trace) + "{\"t\":4,\"kind\":\"expect\",\"state\":\"Asked\",\"holding\":\"null\"}\n");
  std::ostringstream out;
  auto session = Session::load(folder.file("unmet.jsonl"), kinematic());
  REQUIRE(session.ok());
  const auto summary = session->run(out);
  CHECK(summary.expectations == 3);
  CHECK(summary.expectations_met == 2);
  CHECK(of_kind(records_of(out.str()), "expect").back()["found"] == Json{{"state", "Done"}, {"holding", "null"}});
  REQUIRE(summary.unmet.size() == 1);
  CHECK(summary.unmet.front().error("unmet.jsonl").text() ==
        R"(unmet.jsonl:7: expected {"state":"Asked","holding":"null"}, found {"state":"Done","holding":"null"})");
}

TEST_CASE("a branch that was not taken can be taken") {
  const Folder folder;
  folder.write("fork.json", R"json({"machine":1,"name":"fork","start":"A","transitions":[
    {"id":"heavy","from":"A","on":"speech go","to":"B","weight":2},
    {"id":"light","from":"A","on":"speech go","to":"C"},
    {"id":"back","from":["B","C"],"on":"speech back","to":"A"}]})json");
  folder.write("fork.jsonl", R"json({"kind":"trace","version":1,"scene":"staircase","machine":"fork.json"}
{"t":1,"kind":"speech","text":"go"}
{"t":2,"kind":"speech","text":"back"}
{"t":3,"kind":"speech","text":"go"}
)json");
  const auto run = [&](const std::map<int, std::string>& forced, ReplaySummary& summary) {
    auto options = kinematic();
    options.forced = forced;
    auto session = Session::load(folder.file("fork.jsonl"), options);
    if (!session) return session.error().text();
    std::ostringstream out;
    summary = session->run(out);
    std::string taken;
    for (const auto& record : of_kind(records_of(out.str()), "transition"))
      taken += fmt::format("{}:{}{} ", record["step"].get<int>(), record["id"].get<std::string>(),
                           record["forced"].get<bool>() ? "!" : "");
    return taken;
  };
  ReplaySummary summary;
  CHECK(run({}, summary) == "1:heavy 2:back 3:heavy ");
  CHECK(run({{3, "light"}}, summary) == "1:heavy 2:back 3:light! ");
  CHECK(summary.not_forced.empty());
  CHECK(run({{1, "light"}, {2, "heavy"}, {9, "light"}}, summary) == "1:light! 2:back 3:heavy ");
  CHECK(summary.not_forced == std::map<int, std::string>{{2, "heavy"}, {9, "light"}});
  CHECK(run({{1, "lihgt"}}, summary) ==
        "--force 1=lihgt: the machine fork has no transition 'lihgt' (did you mean 'light'?)");
}

TEST_CASE("values of the machine are set for a run, and the log tells them") {
  Folder folder;
  auto rivals = Json::parse(machine);
  rivals["parameters"]["polite"] = {{"value", true}};
  rivals["states"]["Done"]["enter"] = Json::array({{{"when", "polite"}, {"say", "OK."}}});
  for (const char* id : {"nod", "shrug"})
    rivals["transitions"].push_back({{"id", id}, {"from", "Done"}, {"on", "speech what"}, {"to", "Wait"}});
  folder.write("fetch.json", rivals.dump());
  const auto run_with = [&](const Json& settings) {
    auto options = kinematic();
    options.settings = settings;
    return records_of(log_of(folder.file("talk.jsonl"), options));
  };
  const auto last_transition = [](const std::vector<Json>& records) {
    return of_kind(records, "transition").back()["id"].get<std::string>();
  };
  const auto with = run_with({{"polite", false}, {"weights.shrug", 3}});
  CHECK(with[0]["parameters"] == Json{{"polite", false}, {"weights.shrug", 3}});
  CHECK(of_kind(with, "utterance").size() + 1 == of_kind(run_with(Json::object()), "utterance").size());
  CHECK(last_transition(with) == "shrug");
  CHECK(last_transition(run_with({{"weights.nod", 3}})) == "nod");

  // A trace's header sets them just so, and another machine has those that it knows.
  const std::string headed = trace;
  folder.write(
      "set.jsonl",
      R"({"kind":"trace","version":1,"scene":"staircase","machine":"fetch.json","parameters":{"weights.shrug":3,"polite":true}})" +
          headed.substr(headed.find('\n')));
  CHECK(last_transition(records_of(log_of(folder.file("set.jsonl")))) == "shrug");
  auto other = kinematic();
  other.machine = folder.file("other.json");
  folder.write("other.json", machine);
  CHECK_FALSE(records_of(log_of(folder.file("set.jsonl"), other))[0].contains("parameters"));

  auto wrong = kinematic();
  wrong.settings = {{"polit", true}};
  CHECK(Session::load(folder.file("talk.jsonl"), wrong).error().text() ==
        "--set: the machine fetch has no parameter 'polit' (did you mean 'polite'?)");
}

TEST_CASE("explore carries all branches along, what one does is done, what the others are is told") {
  const Folder folder;
  folder.write("hearing.json", R"json({"machine":1,"name":"hearing","start":"A","choice":"explore",
    "states":{"A":{},"B":{"enter":[{"say":"B"}]},"C":{"enter":[{"say":"C"}]},"D":{"enter":[{"say":"D"}]}},"transitions":[
    {"id":"likely","from":"A","on":"speech go","to":"B","weight":3},
    {"id":"less","from":"A","on":"speech go","to":"C"},
    {"id":"on","from":"C","on":"speech on","to":"D"}]})json");
  folder.write("hearing.jsonl", R"json({"kind":"trace","version":1,"scene":"staircase","machine":"hearing.json"}
{"t":1,"kind":"speech","text":"go"}
{"t":2,"kind":"expect","state":"B"}
{"t":3,"kind":"speech","text":"on"}
{"t":4,"kind":"expect","state":"D"}
)json");
  const auto records = records_of(log_of(folder.file("hearing.jsonl")));
  std::string said;
  for (const auto& record : of_kind(records, "utterance")) said += record["text"].get<std::string>();
  CHECK(said == "BD");
  const auto branches = of_kind(records, "branches");
  REQUIRE(branches.size() == 2);
  CHECK(branches[0]["branches"].size() == 2);
  CHECK(branches[0]["branches"][0]["state"] == "B");
  CHECK(branches[0]["branches"][1]["weight"] == 0.25);
  CHECK(branches[1]["dropped"] == Json::parse("[0]"));
  for (const auto& record : of_kind(records, "expect")) CHECK(record["met"] == true);
  CHECK(records.front()["most_branches"] == 64);

  auto options = kinematic();
  options.most_branches = 1;
  std::ostringstream out;
  CHECK(Session::load(folder.file("hearing.jsonl"), options)->run(out).pruned == 1);
  options.forced = {{1, "less"}};
  const auto refused = Session::load(folder.file("hearing.jsonl"), options);
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().where == "--force");
}

TEST_CASE("what cannot be replayed is told in a line that names file, line and expectation") {
  const Folder folder;
  const auto error = [&](const std::string& content) {
    folder.write("broken.jsonl", content);
    const auto session = Session::load(folder.file("broken.jsonl"), kinematic());
    return session.ok() ? std::string() : session.error().text();
  };
  CHECK(error("").find("broken.jsonl:1") != std::string::npos);
  CHECK(error(R"({"kind":"trace","version":1,"scene":"stairs","machine":"fetch.json"})").find("staircase") !=
        std::string::npos);
  CHECK(error(R"({"kind":"trace","version":1,"scene":"staircase","machine":"fetsh.json"})").find("broken.jsonl:1") !=
        std::string::npos);
  CHECK(error(R"({"kind":"trace","version":1,"scene":"staircase","machine":"talk.jsonl"})")
            .find("talk.jsonl:2:1: not valid JSON") != std::string::npos);
}

TEST_CASE("real sessions replay to their last event, the same twice") {
  const fs::path sessions = fs::path(source_dir()) / "../shared/data/pilot2018";
  if (!fs::exists(sessions)) {
    WARN("skipped: no recorded sessions at " << sessions);
    return;
  }
  const Folder folder;
  for (const char* name : {"PilotStudy12-2018-02-08-100753", "PilotStudy11-2018-02-07-114731"}) {
    CAPTURE(name);
    const auto imported = import_session((sessions / (std::string(name) + ".txt")).string());
    REQUIRE(imported.ok());
    folder.write("real.jsonl", write_trace(*imported));
    const auto log = log_of(folder.file("real.jsonl"));
    CHECK(log == log_of(folder.file("real.jsonl")));
    const auto records = records_of(log);
    CHECK(of_kind(records, "problem").empty());
    std::set<std::pair<double, std::string>> said;
    for (const auto& record : of_kind(records, "utterance"))
      said.emplace(record["t"].get<double>(), record["text"].get<std::string>());
    int spoken = 0, reproduced = 0;
    for (const auto& record : of_kind(records, "observed")) {
      if (record["channel"] != "speech") continue;
      ++spoken;
      reproduced += said.contains({record["t"].get<double>(), record["content"].get<std::string>()});
    }
    CHECK(reproduced * 10 >= spoken * 9);
  }
}
