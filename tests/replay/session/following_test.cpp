// Replays that follow another avatar's observed moves.
#include "continua/replay/session/following.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "continua/core/located_json.h"
#include "continua/replay/session/session.h"
#include "support/catch.h"

using namespace continua;
namespace fs = std::filesystem;

namespace {

const char* machine = R"json({
  "machine": 1, "name": "picker", "start": "Wait", "repeat_utterances": false,
  "parameters": { "fast": { "value": false } },
  "programs": { "put": "e -> loc -> t" },
  "slots": { "indicated": "e" },
  "define": { "named": "\\c. head(filter(scene, \\o. attribute(o, 'color') = c))" },
  "states": {
    "Wait": {}, "Asked": { "enter": [{ "say": "The {attribute(indicated, 'color')} one?" }] },
    "Done": { "enter": [{ "say": "OK." }, { "act": "put(indicated, <0.1, 0.05, 0>)" }] } },
  "transitions": [
    { "id": "name", "from": "*", "on": ["speech red", "speech green"], "to": "Asked", "push": { "indicated": "named(nth(words(input), 1))" } },
    { "id": "yes", "from": "Asked", "on": "speech yes", "to": "Done" } ],
  "implied": [
    { "when": "mentions(observed_speech, 'one?')", "to": "Asked",
      "stack": [{ "flush": {} }, { "push": { "indicated": "named(nth(words(observed_speech), 1))" } }] } ] })json";

const char* header = R"json({"kind":"trace","version":1,"scene":"staircase","machine":"picker.json"})json";

struct Play {
  Play() : folder(fs::temp_directory_path() / ("continua_following_" + std::to_string(::getpid()))) {
    fs::create_directories(folder);
    std::ofstream(folder / "picker.json") << machine;
  }
  ~Play() { fs::remove_all(folder); }

  Result<Session> load(const std::string& events, Variant variant, const std::string& first = header) {
    std::ofstream(folder / "t.jsonl") << first << '\n' << events;
    ReplayOptions options;
    options.physics = false;
    options.episodes = true;
    options.variant = variant;
    return Session::load((folder / "t.jsonl").string(), options);
  }

  void run(const std::string& events, Variant variant) {
    auto session = load(events, variant);
    if (!session) FAIL(session.error().text());
    std::ostringstream log;
    summary = session->run(log);
    records.clear();
    poses.clear();
    std::istringstream lines(log.str());
    for (std::string line; std::getline(lines, line);) {
      records.push_back(Json::parse(line));
      if (records.back()["kind"] == "pose")
        for (const auto& [name, pose] : records.back()["bodies"].items()) poses[name] = pose;
    }
  }

  // The agreement of each episode.
  std::string levels() const {
    std::string all;
    for (const auto& episode : summary.episodes) all += (all.empty() ? "" : " ") + name_of(episode.level);
    return all;
  }
  std::string act() const {
    for (const auto& record : records)
      if (record["kind"] == "act") return record["program"].get<std::string>();
    return "none";
  }
  std::vector<Json> of(const std::string& kind) const {
    std::vector<Json> found;
    for (const auto& record : records)
      if (record["kind"] == kind) found.push_back(record);
    return found;
  }

  fs::path folder;
  ReplaySummary summary;
  std::vector<Json> records;
  std::map<std::string, Json> poses;
};

std::string speech(double t, const std::string& words) {
  return R"({"t":)" + std::to_string(t) + R"(,"kind":"speech","text":")" + words + "\"}\n";
}
std::string observed(double t, const std::string& channel, const std::string& content) {
  return R"({"t":)" + std::to_string(t) + R"(,"kind":"observed","channel":")" + channel + R"(","content":")" + content +
         "\"}\n";
}
std::string sample(double t) {
  return R"({"t":)" + std::to_string(t) + R"(,"kind":"pointing","hand":"right","target":[0,0]})" + "\n";
}

const std::string asked_otherwise = speech(1, "red") + observed(1, "speech", "The green one?") + speech(2, "yes") +
                                    observed(2, "speech", "OK.") + observed(2, "action", "put(block4, <0.1, 0.02, 0>)");

}  // namespace

TEST_CASE("a free run does not know what was observed") {
  Play play;
  play.run(asked_otherwise, Variant::free);
  CHECK(play.act() == "put(block6, <0.1, 0.05, 0>)");
  CHECK(play.levels() == "template template");
  CHECK(play.poses["block6"] == Json({0.1, 0.05, 0.03, 1.0, 0.0, 0.0, 0.0}));
  CHECK_FALSE(play.poses.contains("block4"));
  CHECK_FALSE(play.records.front().contains("variant"));
}

TEST_CASE("in a world that follows, observed acts move things and the engine's own do not") {
  Play play;
  play.run(asked_otherwise, Variant::world);
  CHECK(play.act() == "put(block6, <0.1, 0.05, 0>)");
  CHECK(play.levels() == "template template");
  CHECK(play.poses["block4"] == Json({0.1, 0.02, 0.03, 1.0, 0.0, 0.0, 0.0}));
  CHECK(play.poses["block6"] != Json({0.1, 0.05, 0.03, 1.0, 0.0, 0.0, 0.0}));
  CHECK(play.of("correction").empty());
  CHECK(play.records.front()["variant"] == "world");
}

TEST_CASE("with a teacher the dialogue goes on from what was observed") {
  Play play;
  play.run(asked_otherwise, Variant::teacher);
  CHECK(play.act() == "put(block4, <0.1, 0.05, 0>)");
  REQUIRE(play.of("correction").size() == 1);
  const auto correction = play.of("correction").front();
  CHECK(correction["from"] == "Asked");
  CHECK(correction["to"] == "Asked");
  CHECK(correction["implied"] == 1);
  CHECK(correction["t"] == 1.0);
  CHECK(play.of("symbol")[3]["slots"]["indicated"] == "block4");
}

TEST_CASE("what was not observed is undone by a teacher") {
  Play play;
  play.run(speech(1, "red") + speech(2, "yes") + speech(3, "green") + observed(3, "speech", "The green one?") +
               speech(4, "yes"),
           Variant::teacher);
  CHECK(play.levels() == "none exact exact none");
  CHECK(play.of("refusal").size() == 1);
  CHECK(play.of("correction").front()["implied"] == Json(nullptr));
  CHECK(play.of("correction").front()["to"] == "Wait");
}

TEST_CASE("an answer that takes time is waited for until the next input that is no sample") {
  Play play;
  const auto events = speech(1, "red") + sample(1.3) + sample(1.6) + observed(1.7, "speech", "The green one?") +
                      sample(1.8) + speech(3, "yes") + observed(3.5, "speech", "OK.") +
                      observed(3.5, "action", "put(block4, <0.1, 0.05, 0>)");
  play.run(events, Variant::teacher);
  CHECK(play.act() == "put(block4, <0.1, 0.05, 0>)");
  CHECK(play.levels() == "template exact exact exact exact");
  CHECK(play.of("correction").size() == 1);
}

TEST_CASE("the same run twice") {
  Play play;
  play.run(asked_otherwise, Variant::teacher);
  const auto first = play.records;
  play.run(asked_otherwise, Variant::teacher);
  CHECK(play.records == first);
}

TEST_CASE("what does not go with following is told") {
  Play play;
  auto session = play.load(asked_otherwise, Variant::world);
  REQUIRE(session);
  const auto problem_of = [&](auto change) {
    ReplayOptions options;
    options.physics = false;
    options.variant = Variant::teacher;
    change(options);
    const auto loaded = Session::load((play.folder / "t.jsonl").string(), options);
    return loaded ? std::string("none") : loaded.error().text();
  };
  CHECK(problem_of([](ReplayOptions& options) { options.physics = true; }).starts_with("--variant: "));
  CHECK(problem_of([](ReplayOptions& options) { options.from = 1; }).starts_with("--variant: "));
  CHECK(problem_of([](ReplayOptions& options) { options.choice = Choice::explore; }).starts_with("--variant: "));
  CHECK(problem_of([](ReplayOptions&) {}) == "none");
}

TEST_CASE("a trace sets parameters of its machine, and another machine those it knows") {
  Play play;
  const std::string sets =
      R"json({"kind":"trace","version":1,"scene":"staircase","machine":"picker.json","parameters":)json";
  auto session = play.load(asked_otherwise, Variant::free, sets + R"({"fast":true}})");
  REQUIRE(session);
  std::ostringstream log;
  session->run(log);
  CHECK(Json::parse(log.str().substr(0, log.str().find('\n')))["parameters"] == Json{{"fast", true}});
  const auto unknown = play.load(asked_otherwise, Variant::free, sets + R"({"fats":true}})");
  REQUIRE_FALSE(unknown);
  CHECK(unknown.error().text().find("t.jsonl:1: the machine picker has no parameter 'fats' (did you mean 'fast'?)") !=
        std::string::npos);
  play.load(asked_otherwise, Variant::free, sets + R"({"fats":1,"fast":true}})").ok();
  ReplayOptions other;
  other.physics = false;
  other.machine = (play.folder / "picker.json").string();
  auto with_other = Session::load((play.folder / "t.jsonl").string(), other);
  REQUIRE(with_other);
  log.str("");
  with_other->run(log);
  CHECK(Json::parse(log.str().substr(0, log.str().find('\n')))["parameters"] == Json{{"fast", true}});
}
