// Lessons of one replay are known in the next.
#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/replay/commands/replay.h"
#include "continua/replay/session/learned_file.h"
#include "continua/replay/session/session.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

// A machine that learns on command, and says its lessons.
struct Lessons {
  Lessons() {
    folder.file("words.json", R"({"phrases":1,"say":{"ask_thing":[{"say":"Which one?"}]}})");
    folder.file("m.json", R"json({"machine":1,"name":"m","start":"A","phrases":")json" + folder.at("words") + R"json(",
      "programs":{"grasp":"e -> t","lift":"e -> t","cup":"e"},"slots":{"acts":"t*"},"bottom":{"acts":"[grasp(cup), lift(cup)]"},
      "transitions":[
      {"id":"teach","from":"A","on":"speech teach","to":"A","do":[{"learn":{"word":"'hoist'","acts":"acts"}}]},
      {"id":"forget","from":"A","on":"speech forget","to":"A","do":[{"forget":"all"}]},
      {"id":"ask","from":"A","on":"speech ask","to":"A","do":[{"say":"{learned('hoist')}"},{"phrase":"ask_thing"}]}]})json");
    for (const std::string words : {"teach", "forget", "ask"})
      folder.file(words + ".jsonl", R"({"kind":"trace","version":1,"scene":"place_setting","machine":"m.json"})" +
                                        fmt::format("\n{{\"t\":1,\"kind\":\"speech\",\"text\":\"{}\"}}\n", words));
  }

  std::vector<Json> replay(const std::string& trace) {
    ReplayOptions options;
    options.physics = false;
    options.learned = folder.at("learned.json");
    auto session = Session::load(folder.at(trace + ".jsonl"), options);
    if (!session) FAIL(session.error().text());
    std::stringstream log;
    session->run(log);
    CHECK_FALSE(session->keep_learned());
    std::vector<Json> records;
    for (std::string line; std::getline(log, line);) records.push_back(Json::parse(line));
    return records;
  }

  Json first(const std::string& trace, const std::string& kind) {
    for (const auto& record : replay(trace))
      if (record["kind"] == kind) return record;
    return nullptr;
  }

  TemporaryFolder folder;
};

}  // namespace

TEST_CASE("what one run was taught the next one knows, and its log says so") {
  Lessons lessons;
  const auto path = lessons.folder.at("learned.json");
  CHECK(lessons.first("ask", "utterance")["text"] == "false");
  CHECK_FALSE(fs::exists(path));
  const auto learned = lessons.first("teach", "learned");
  CHECK(learned["of"] == "word");
  CHECK(learned["name"] == "hoist");
  CHECK(learned["value"] == "\\x: e. [grasp(x), lift(x)]");
  CHECK(learned["because"].size() == 1);
  const auto kept = read_file(path).value();
  CHECK(Json::parse(kept)["programs"]["hoist"]["acts"] == "\\x: e. [grasp(x), lift(x)]");
  CHECK_FALSE(fs::exists(path + ".new"));
  CHECK(lessons.first("ask", "utterance")["text"] == "true");
  CHECK(lessons.first("ask", "run")["learned"] == Json::parse(kept));
  CHECK(read_file(path).value() == kept);
  CHECK(lessons.first("forget", "forgotten")["value"] == "\\x: e. [grasp(x), lift(x)]");
  CHECK(lessons.first("ask", "utterance")["text"] == "false");
  CHECK(lessons.first("ask", "run")["learned"].is_null());
}

TEST_CASE("the log holds the phrases, and what was learned counts among the decisions") {
  Lessons lessons;
  const auto before = lessons.replay("ask");
  CHECK(before.front()["phrases"]["name"] == lessons.folder.at("words"));
  CHECK(before.front()["phrases"]["document"]["say"].contains("ask_thing"));
  const auto taught = lessons.replay("teach");
  fs::remove(lessons.folder.at("learned.json"));
  CHECK(lessons.replay("teach").back()["decisions"] == taught.back()["decisions"]);
  auto machine = read_file(lessons.folder.at("m.json")).value();
  machine.replace(machine.find("'hoist'"), 7, "'raise'");
  lessons.folder.file("m.json", machine);
  fs::remove(lessons.folder.at("learned.json"));
  CHECK_FALSE(lessons.replay("teach").back()["decisions"] == taught.back()["decisions"]);
}

TEST_CASE("several traces follow one another, each with what the ones before it taught") {
  Lessons lessons;
  ReplayCommandOptions options;
  for (const auto* trace : {"teach", "ask", "forget"})
    options.traces.push_back(lessons.folder.at(trace) + std::string(".jsonl"));
  options.output = lessons.folder.at("runs");
  options.jobs = 3;
  options.replay.physics = false;
  options.replay.learned = lessons.folder.at("learned.json");
  CHECK(run_replay(options) == exit_done);
  CHECK(read_file(lessons.folder.at("runs/ask.run.jsonl"))->find(R"("text":"true")") != std::string::npos);
  CHECK(Json::parse(*read_file(options.replay.learned))["programs"].empty());
}

TEST_CASE("a file of what was learned that cannot be used is told, and stays as it is") {
  Lessons lessons;
  ReplayOptions options;
  options.learned = lessons.folder.at("learned.json");
  const auto problem = [&](const std::string& content) {
    lessons.folder.file("learned.json", content);
    const auto session = Session::load(lessons.folder.at("ask.jsonl"), options);
    CHECK(read_file(options.learned).value() == content);
    return session ? "" : session.error().text().substr(options.learned.size());
  };
  CHECK(problem("{").starts_with(":1:"));
  CHECK(problem(R"({"learned":1,"programs":{"grasp":{"acts":"[lift(cup)]"}}})") ==
        ":1:34: the name 'grasp' has another meaning");
  CHECK(problem(R"({"learned":1})").empty());
  CHECK(write_learned(lessons.folder.at("no/such/folder.json"), {}));
}
