// Replays by the inspector: runs as their logs have them, with the changes that a request asks for.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <future>
#include <sstream>

#include "continua/replay/diff/run_diff.h"
#include "continua/replay/experiment/what_if_session.h"
#include "continua/replay/inspector/inspector_api.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/log/record_json.h"
#include "continua/replay/session/session.h"
#include "continua/replay/session/version.h"
#include "continua/simulation/mujoco_version.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"
#include "support/folders.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const fs::path paper = fs::path(source_dir()) / "traces/paper";

struct Asked {
  explicit Asked(const fs::path& logs) : api({logs.string()}, nullptr, replayed_what_if()) {}

  Json post(const Json& request, int status = 200) {
    const auto answer = api.post("/api/what-if", "application/json", request.dump());
    INFO(request << " gave " << answer.body);
    CHECK(answer.status == status);
    return Json::parse(answer.body);
  }
  std::string refused(const Json& request, int status = 400) {
    return post(request, status)["error"]["message"].get<std::string>();
  }
  Json get(const std::string& target) {
    const auto answer = api.get(target);
    INFO(target << " gave " << answer.body);
    REQUIRE(answer.status == 200);
    return Json::parse(answer.body);
  }
  std::vector<Json> whole(const std::string& run, const std::string& kind) {
    const auto answer = get("/api/runs/" + run + "/records?limit=5000&kind=" + kind);
    return answer["records"].get<std::vector<Json>>();
  }
  Json runs() { return get("/api/runs")["runs"]; }

  InspectorApi api;
};

// A worked example's log in a folder of its own, edited.
struct EditedLog {
  explicit EditedLog(const std::string& name) {
    std::istringstream file(read_run_log((paper / (name + ".run.jsonl")).string()).value());
    for (std::string line; std::getline(file, line);) records.push_back(Json::parse(line));
  }
  std::string write() const {
    std::string text;
    for (const auto& record : records) text += compact(record) + "\n";
    return folder.write("edited.run.jsonl", text);
  }
  std::vector<Json> records;
  ScratchFolder folder;
};

}  // namespace

TEST_CASE("without edits every worked example is the same run again") {
  Asked asked(paper);
  int logs = 0;
  const auto runs = asked.runs();
  for (const auto& run : runs) {
    const auto made = asked.post({{"run", run["id"]}});
    INFO(run["id"] << ": " << made);
    ++logs;
    const auto header = asked.whole(run["id"].get<std::string>(), "run").at(0);
    const auto is_ours = header["fingerprint"] == log::to_json(fingerprint());
    CHECK(made.contains("warning") == (header["world"] == "physics" && !is_ours));
    // By another MuJoCo the bodies go elsewhere.
    if (header["world"] == "kinematic" || header["fingerprint"]["mujoco"] == mujoco_version())
      CHECK(made["same"] == true);
  }
  CHECK(logs >= 26);
}

TEST_CASE("a run that was edited is served, and its log is as a replay of the edited trace writes it") {
  Asked asked(paper);
  const auto inputs = asked.whole("dialogue_language", "input");
  REQUIRE(inputs.size() >= 2);
  const auto& input = inputs[0];
  const auto taken_out =
      asked.post({{"run", "dialogue_language"}, {"edits", {{{"n", input["n"]}, {"event", nullptr}}}}});
  CHECK(taken_out["run"] == "what-if-1");
  CHECK(taken_out["same"] == false);
  CHECK_FALSE(taken_out["sentence"].get<std::string>().empty());
  CHECK(asked.whole("what-if-1", "input").size() < inputs.size());
  const auto listed = asked.runs().front();
  CHECK(listed["id"] == "what-if-1");
  CHECK(listed["what_if_of"] == "dialogue_language");
  CHECK(asked.get("/api/diff?a=dialogue_language&b=what-if-1")["same"] == false);

  auto event = input["event"];
  event["text"] = "Nothing that any lexicon knows xyzzy";
  const auto changed = asked.post({{"run", "dialogue_language"}, {"edits", {{{"n", input["n"]}, {"event", event}}}}});
  CHECK(changed["run"] == "what-if-2");
  CHECK(asked.whole("what-if-2", "input")[0]["event"] == event);
  CHECK(asked.whole("what-if-2", "input")[0]["line"] == input["line"]);

  // At another time its record says so, and those that came between come before it.
  const auto late = asked.whole("dialogue_language", "input")[1];
  const auto early = asked.post(
      {{"run", "dialogue_language"}, {"edits", {{{"n", late["n"]}, {"event", late["event"]}, {"t", 0.25}}}}});
  const auto moved = asked.whole(early["run"], "input")[0];
  CHECK(moved["event"] == late["event"]);
  CHECK(moved["t"] == 0.25);
  CHECK_THAT(asked.refused(
                 {{"run", "dialogue_language"}, {"edits", {{{"n", late["n"]}, {"event", late["event"]}, {"t", -1}}}}}),
             Contains("'t' is -1"));

  // A changed run can be changed again, back to the first.
  const auto back = asked.post({{"run", changed["run"]}, {"edits", {{{"n", input["n"]}, {"event", input["event"]}}}}});
  CHECK(asked.get("/api/diff?a=dialogue_language&b=" + back["run"].get<std::string>())["same"] == true);
}

TEST_CASE("a forced transition, a seed and a choice count from the instant that is asked for") {
  Asked asked(paper);
  const std::string base = asked.post({{"run", "special_nfa"}, {"choice", "likeliest"}})["run"];
  int forced = 0;
  for (const auto& transition : asked.whole(base, "transition")) {
    if (transition["candidates"].size() < 2) continue;
    for (const auto& candidate : transition["candidates"]) {
      if (candidate["id"] == transition["id"]) continue;
      const auto step = std::to_string(transition["step"].get<int>());
      const auto made = asked.post({{"run", base}, {"force", {{step, candidate["id"]}}}});
      const auto again = asked.whole(made["run"], "transition");
      const auto same_step = std::find_if(again.begin(), again.end(),
                                          [&](const Json& other) { return other["step"] == transition["step"]; });
      REQUIRE(same_step != again.end());
      CHECK((*same_step)["id"] == candidate["id"]);
      CHECK((*same_step)["forced"] == true);
      ++forced;
    }
  }
  CHECK(forced >= 3);
  const auto later = asked.post({{"run", "disambiguation"}, {"from", 3}, {"choice", "sample"}, {"seed", 7}});
  const auto header = asked.get("/api/runs/" + later["run"].get<std::string>() + "/records?limit=1")["records"][0];
  CHECK(header["choice"] == "likeliest");
  CHECK(header["seed"] == 0);
  CHECK(header["what_if"]["from"] == 3);
  CHECK(header["what_if"]["choice"] == "sample");
  CHECK(header["what_if"]["seed"] == 7);
  CHECK_THAT(asked.refused({{"run", later["run"]}}), Contains("changed in mid-run"));
}

TEST_CASE("what cannot be asked for is told as a sentence") {
  Asked asked(paper);
  const auto input = asked.whole("correction", "input").front()["n"].get<std::size_t>();
  const auto transition = asked.whole("correction", "transition").front()["n"].get<std::size_t>();
  const Json event{{"kind", "speech"}, {"text", "No."}};
  const auto edit = [&](const Json& n, const Json& to) {
    return Json{{"run", "correction"}, {"edits", {{{"n", n}, {"event", to}}}}};
  };
  const auto with = [](const char* key, Json value) { return Json{{"run", "correction"}, {key, std::move(value)}}; };
  CHECK_THAT(asked.refused(Json::array()), Contains("expected an object"));
  CHECK_THAT(asked.refused({{"seed", 1}}), Contains("'run' is missing"));
  CHECK_THAT(asked.refused({{"run", "nobody"}}), Contains("there is no run 'nobody'"));
  CHECK_THAT(asked.refused(with("machine", "other")), Contains("'machine'"));
  CHECK_THAT(asked.refused(edit(transition, event)), Contains("is no input"));
  CHECK_THAT(asked.refused(edit(1e6, event)), Contains("n"));
  CHECK_THAT(asked.refused(edit(1000000, event)), Contains("the run has records 0 to"));
  CHECK_THAT(asked.refused(edit(-1, event)), Contains("edit 1"));
  CHECK_THAT(asked.refused(edit(input, "No.")), Contains("edit 1"));
  CHECK_THAT(asked.refused(edit(input, {{"kind", "speech"}})), Contains("text"));
  CHECK_THAT(asked.refused(edit(input, {{"kind", "speech"}, {"text", "No."}, {"t", 3}})), Contains("found 't'"));
  auto twice = edit(input, event);
  twice["edits"].push_back(twice["edits"][0]);
  CHECK_THAT(asked.refused(twice), Contains("twice"));
  auto before = edit(input, event);
  before["from"] = 30;
  CHECK_THAT(asked.refused(before), Contains("from 30 s on"));
  CHECK_THAT(asked.refused(with("from", -1)), Contains("'from' is -1"));
  CHECK_THAT(asked.refused(with("force", {{"zero", "x"}})), Contains("is no step"));
  CHECK_THAT(asked.refused(with("force", {{"0", "x"}})), Contains("is no step"));
  CHECK_THAT(asked.refused(with("force", {{"1", 2}})), Contains("expected a transition's id"));
  CHECK_THAT(asked.refused(with("force", {{"1", "nothing of it"}})), Contains("nothing of it"));
  const auto first = asked.whole("correction", "transition").front()["id"];
  CHECK_THAT(asked.refused(with("force", {{"999", first}})), Contains("does not apply"));
  CHECK_THAT(asked.refused(with("choice", "worst")), Contains("worst"));
  CHECK_THAT(asked.refused(with("seed", "one")), Contains("'seed'"));
  CHECK(asked.runs().back()["id"] != "what-if-1");

  const auto text = [&](const std::string& type, const std::string& body) {
    return asked.api.post("/api/what-if", type, body).status;
  };
  CHECK(text("text/plain", "{}") == 415);
  CHECK(text("application/json; charset=utf-8", "{") == 400);
  CHECK(text("application/json", "") == 400);
  CHECK(asked.api.post("/api/runs", "application/json", "{}").status == 405);
  CHECK(InspectorApi({paper.string()}).post("/api/what-if", "application/json", R"({"run":"correction"})").status ==
        501);
}

TEST_CASE("machine, phrases, scene and places of the log are replayed, whatever the program's own are") {
  EditedLog log("dialogue_language");
  auto& header = log.records[0];
  // Said with other phrases and by another machine of the same name.
  header["machine"]["document"]["about"] = "edited";
  header["machine"]["digest"] = "0";
  header["phrases"]["document"]["about"] = "edited";
  header["phrases"]["digest"] = "0";
  header["knowledge"]["lexicon/other.json"] = "0";
  Asked asked(log.write());
  const auto made = asked.post({{"run", "edited"}});
  CHECK(made["same"] == true);
  CHECK_THAT(made["warning"].get<std::string>(), Contains("lexicon/other.json"));
  const auto again = asked.get("/api/runs/what-if-1/records?limit=1")["records"][0];
  CHECK(again["machine"]["document"]["about"] == "edited");
  CHECK(again["phrases"]["document"]["about"] == "edited");
}

TEST_CASE("objects begin where the log has them") {
  const auto trace = fs::path(source_dir()) / "traces/paper/correction.trace.jsonl";
  std::ifstream file(trace);
  std::string text, line;
  std::getline(file, line);
  auto header = Json::parse(line);
  header["objects"] = {{"knife", nullptr},
                       {"cup", {{"position", {-0.21234567, 0.2, 0.05}}, {"yaw", 0.7}}},
                       {"plate", {{"position", {0.25, 0.2, 0.01}}}}};
  text = compact(header) + "\n";
  while (std::getline(file, line)) text += line + "\n";
  for (const bool physics : {false, true}) {
    const ScratchFolder folder;
    ReplayOptions options;
    options.physics = physics;
    auto session = Session::load(folder.write("moved.trace.jsonl", text), options);
    REQUIRE(session.ok());
    std::ostringstream log;
    session->run(log);
    folder.write("moved.run.jsonl", log.str());
    Asked asked(folder.path());
    const auto made = asked.post({{"run", "moved"}});
    INFO(made);
    CHECK(made["same"] == true);
    const auto bodies = asked.get("/api/runs/what-if-1/scene")["bodies"];
    CHECK_FALSE(bodies.contains("knife"));
    CHECK(bodies["cup"][0].get<double>() == Approx(-0.21235).margin(1e-5));
  }
}

TEST_CASE("logs that are broken, cut or of something else are told of") {
  const EditedLog original("correction");
  // Any member of the header may be missing or wrong.
  for (const auto& [key, ignored] : original.records[0].items())
    for (const Json& value :
         {Json(), Json(-1), Json("x"), Json::array({1, "y"}), Json{{"document", 3}, {"mjcf", ""}}}) {
      EditedLog log("correction");
      if (key == "kind" || key == "n" || key == "t" || key == "version") continue;  // a log of another kind
      log.records[0][key] = value;
      log.records.resize(20);
      Asked asked(log.write());
      const auto answer = asked.api.post("/api/what-if", "application/json", R"({"run":"edited"})");
      INFO(key << " is " << value << ": " << answer.body);
      CHECK((answer.status == 200 || answer.status == 400));
    }
  // Records of any form.
  for (const Json& event : {Json(), Json(3), Json::object(), Json{{"kind", 7}}, Json{{"kind", "speech"}}}) {
    EditedLog log("correction");
    for (auto& record : log.records)
      if (record["kind"] == "input" || record["kind"] == "expect") {
        record["event"] = event;
        record["line"] = "two";
        record["expected"] = event;
      }
    Asked asked(log.write());
    const auto answer = asked.api.post("/api/what-if", "application/json", R"({"run":"edited"})");
    INFO(event << ": " << answer.body);
    CHECK((answer.status == 200 || answer.status == 400));
  }
}

TEST_CASE("two runs are replayed at a time and no more") {
  // Waits until it is told to go on.
  struct Waiting : RunWhatIf {
    Result<Replayed> replay(const RunIndex&, const WhatIfRequest&, const std::string&,
                            const std::atomic<bool>& stop) override {
      ++begun;
      while (!stop) std::this_thread::yield();
      return Error{"", "stopped"};
    }
    Result<Replayed> replay_trace(const std::string&, const std::string&, const std::atomic<bool>&) override {
      return Error{"", "not here"};
    }
    std::atomic<int> begun = 0;
  };
  const auto waiting = std::make_shared<Waiting>();
  InspectorApi api({(paper / "correction.run.jsonl").string()}, nullptr, waiting);
  const auto ask = [&] { return api.post("/api/what-if", "application/json", R"({"run":"correction"})").status; };
  auto first = std::async(std::launch::async, ask), second = std::async(std::launch::async, ask);
  while (waiting->begun < 2) std::this_thread::yield();
  CHECK(ask() == 503);
  CHECK(api.get("/api/runs").status == 200);
  api.stop();
  CHECK(first.get() == 400);
  CHECK(second.get() == 400);
}

TEST_CASE("what was written for replays is gone at the end") {
  const ScratchFolder temporary;
  const auto before = std::getenv("TMPDIR") ? std::string(std::getenv("TMPDIR")) : std::string();
  ::setenv("TMPDIR", temporary.path().c_str(), 1);
  {
    Asked asked(paper);
    asked.post({{"run", "correction"}});
    CHECK_FALSE(fs::is_empty(temporary.path()));
  }
  CHECK(fs::is_empty(temporary.path()));
  if (before.empty())
    ::unsetenv("TMPDIR");
  else
    ::setenv("TMPDIR", before.c_str(), 1);
}
