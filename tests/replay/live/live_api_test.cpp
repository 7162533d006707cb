#include "continua/replay/live/live_api.h"

#include <filesystem>

#include "continua/replay/check/check.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

class Asked {
 public:
  explicit Asked(LiveDefaults more = {}) : api_(sessions(std::move(more))) {}

  Json get(const std::string& target, int status = 200) { return read(api_.get(target), status); }
  Json post(const std::string& target, const std::string& body = "", int status = 200) {
    return read(api_.post(target, body), status);
  }
  std::string refused(int status, const std::string& target, const std::string& body = "") {
    return post(target, body, status)["error"]["message"];
  }
  std::string file(const std::string& name) { return read_file(folder.at(name)).value(); }

  const TemporaryFolder folder;

 private:
  std::shared_ptr<LiveSessions> sessions(LiveDefaults more) {
    more.folder = folder.path().string();
    more.tests = folder.at("tests");
    more.replay.physics = false;
    auto created = LiveSessions::create(std::move(more));
    REQUIRE(created.ok());
    return *created;
  }
  static Json read(const ApiResponse& response, int status) {
    INFO(response.body);
    CHECK(response.status == status);
    return Json::parse(response.body);
  }

  LiveApi api_;
};

constexpr auto plate = R"({"t":1,"kind":"speech","text":"The plate."})";

}  // namespace

TEST_CASE("a session is begun, told events, ended and saved as a test that passes") {
  Asked asked;
  const auto offered = asked.get("/api/sessions");
  CHECK(offered["sessions"].empty());
  for (const char* field : {"scene", "machine"}) {
    const auto& names = offered[std::string(field) + "s"];
    CHECK(std::find(names.begin(), names.end(), offered[field]) != names.end());
  }
  for (const auto& button : offered["buttons"])
    CHECK(read_event(button["event"].is_object() ? [&] {
          Json event = button["event"];
          event["t"] = 0;
          return event;
        }() : Json(), "button", 1).ok());

  const auto begun = asked.post("/api/sessions", R"({"objects":{"cup":null}})", 201);
  CHECK(begun["id"] == "session");
  CHECK(begun["live"] == true);
  CHECK(begun["gestures"].size() > 20);
  const auto reply = asked.post("/api/sessions/session/events", plate);
  CHECK(reply["accepted"] == 1);
  CHECK(reply["t"] == 1);
  REQUIRE(reply["moves"].size() == 2);
  CHECK(reply["moves"][1]["text"] == "Okay, go on.");
  CHECK(asked.get("/api/sessions/session")["clock"] == "events");
  CHECK(asked.get("/api/sessions")["sessions"].size() == 1);

  // While it is live, the events so far are saved.
  const auto first = asked.post("/api/sessions/session/save", R"({"name":"first"})", 201);
  asked.post("/api/sessions/session/events",
             R"([{"t":2,"kind":"speech","text":"Put it in front of you."},{"t":9,"kind":"clock"}])");
  CHECK(asked.post("/api/sessions/session/end")["live"] == false);
  CHECK(asked.post("/api/sessions/session/end")["live"] == false);
  const auto second = asked.post("/api/sessions/session/save", R"({"name":"second"})", 201);
  CHECK(second["check"] == "continua check " + asked.folder.at("tests/second.trace.jsonl"));
  for (const auto& saved : {first, second})
    for (const bool physics : {false, true}) {
      ReplayOptions options;
      options.physics = physics;
      CHECK_FALSE(is_failure(check_trace(saved["trace"].get<std::string>(), options).verdict));
    }
  CHECK_THAT(asked.file("tests/second.trace.jsonl"), Contains("front of you") && Contains(R"("objects":{"cup":null})"));
  CHECK_THAT(asked.refused(409, "/api/sessions/session/save", R"({"name":"second"})"), Contains("exists already"));
}

TEST_CASE("what cannot be is refused, and says what could") {
  Asked asked;
  CHECK(asked.refused(400, "/api/sessions", "{\"scene\":") != "");
  CHECK_THAT(asked.refused(400, "/api/sessions", "[]"), Contains("expected an object"));
  CHECK_THAT(asked.refused(400, "/api/sessions", R"({"scen":"x"})"), Contains("did you mean 'scene'?"));
  CHECK_THAT(asked.refused(400, "/api/sessions", R"({"scene":"../../etc/passwd"})"), Contains("place_setting"));
  CHECK_THAT(asked.refused(400, "/api/sessions", R"({"machine":7})"), Contains("expected one of"));
  CHECK_THAT(asked.refused(400, "/api/sessions", R"({"seed":-1})"), Contains("'seed'"));
  CHECK_THAT(asked.refused(400, "/api/sessions", R"({"objects":[]})"), Contains("'objects'"));
  CHECK_THAT(asked.refused(400, "/api/sessions", R"({"clock":"sun"})"), Contains("\"wall\" or \"events\""));
  CHECK_THAT(asked.refused(400, "/api/sessions", R"({"speed":0})"), Contains("0.01 to 100"));
  CHECK_THAT(asked.refused(400, "/api/sessions", R"({"name":"../x"})"), Contains("letters, digits"));
  CHECK_THAT(asked.refused(422, "/api/sessions", R"({"objects":{"no_such":null}})"), Contains("no_such"));
  CHECK(fs::is_empty(asked.folder.path()));

  asked.post("/api/sessions", R"({"name":"one"})", 201);
  asked.refused(404, "/api/sessions/two/events", plate);
  asked.refused(404, "/api/sessions/one/evnts", plate);
  asked.refused(400, "/api/sessions/one/events", "");
  asked.refused(400, "/api/sessions/one/events", "{");
  asked.refused(400, "/api/sessions/one/events", R"({"kind":"speech"})");
  asked.refused(400, "/api/sessions/one/pause", R"({"paused":1})");
  asked.refused(400, "/api/sessions/one/save", R"({"name":"a/b"})");
  CHECK(asked.get("/api/sessions/one/events", 405)["error"]["message"] == "this address takes a POST");
  asked.post("/api/sessions/one/end");
  asked.refused(409, "/api/sessions/one/events", plate);
  asked.refused(409, "/api/sessions/one/pause", R"({"paused":true})");
}

TEST_CASE("a trace's header begins the session that it is of") {
  Asked asked;
  const std::string header = R"({"kind":"trace","version":1,"scene":"staircase","machine":"diana2018","source":"x"})";
  const auto begun = asked.post("/api/sessions", header, 201);
  CHECK(begun["scene"] == "staircase");
  CHECK(begun["machine"] == "diana2018");
  CHECK_THAT(asked.refused(400, "/api/sessions", R"({"kind":"trace","version":2})"), Contains("expected 1"));
}

TEST_CASE("what is sent again since its answer was lost is not taken again") {
  Asked asked;
  asked.post("/api/sessions", "", 201);
  const std::string events = "/api/sessions/session/events";
  const auto first = asked.post(events + "?batch=1", plate);
  const auto trace = asked.file("session.trace.jsonl");
  CHECK(asked.post(events + "?batch=1", plate) == first);
  CHECK(asked.file("session.trace.jsonl") == trace);
  asked.post(events + "?batch=2", plate);
  CHECK(asked.file("session.trace.jsonl") != trace);
}

TEST_CASE("only whoever records into a session may") {
  Asked asked;
  asked.post("/api/sessions", R"({"recorder":"me"})", 201);
  const std::string session = "/api/sessions/session";
  for (const std::string who : {"", "?recorder=you"})
    for (const std::string what : {"/events", "/pause", "/end"})
      CHECK(asked.refused(409, session + what + who, plate) == "somebody else records into this session");
  CHECK(asked.get(session)["t"] == 0);
  CHECK_FALSE(asked.get(session).contains("recorder"));
  asked.post(session + "/events?recorder=me", plate);
}

TEST_CASE("a flood is refused before any of it counts") {
  Asked asked;
  asked.post("/api/sessions", R"({"clock":"events"})", 201);
  const auto many = [](const std::string& event) {
    std::string body;
    for (int i = 0; i < 3900; ++i) body += event + "\n";
    return body;
  };
  // An instant that has come already costs nothing: a program built for debugging is flooded too.
  asked.post("/api/sessions/session/events", many(R"({"t":1,"kind":"clock"})"));
  const auto trace = asked.file("session.trace.jsonl");
  asked.refused(429, "/api/sessions/session/events", many(R"({"t":1,"kind":"gesture","name":"x","phase":"stop"})"));
  CHECK(asked.file("session.trace.jsonl") == trace);
}

TEST_CASE("so many sessions may be live, each with files of its own") {
  Asked asked;
  asked.folder.file("session-2.trace.jsonl", "mine");
  for (int i = 0; i < 8; ++i) asked.post("/api/sessions", "", 201);
  CHECK(asked.file("session-2.trace.jsonl") == "mine");
  CHECK(fs::exists(asked.folder.at("session-9.run.jsonl")));
  CHECK_THAT(asked.refused(503, "/api/sessions"), Contains("end one first"));
  asked.post("/api/sessions/session-3/end");
  asked.post("/api/sessions", "", 201);
  // One that its recorder has left makes room.
  asked.post("/api/sessions/session-4/away", R"({"gone":true})");
  asked.post("/api/sessions", "", 201);
  CHECK(asked.get("/api/sessions/session-4")["live"] == false);
  asked.refused(400, "/api/sessions/session-5/away", R"({"gone":1})");
}

TEST_CASE("a server begins so many sessions, however soon each ends") {
  LiveDefaults defaults;
  defaults.most_begun = 3;
  Asked asked(defaults);
  for (const std::string id : {"session", "session-2", "session-3"}) {
    asked.post("/api/sessions", "", 201);
    asked.post("/api/sessions/" + id + "/end");
  }
  asked.refused(503, "/api/sessions");
  CHECK_FALSE(fs::exists(asked.folder.at("session-4.trace.jsonl")));
}

TEST_CASE("a machine that knows gestures by their names offers those, in words") {
  LiveDefaults defaults;
  defaults.machine = "diana2018";
  defaults.scene = "staircase";
  Asked asked(defaults);
  const auto gestures = asked.post("/api/sessions", "", 201)["gestures"];
  const auto offers = [&](const std::string& label) {
    return std::any_of(gestures.begin(), gestures.end(), [&](const Json& one) { return one["label"] == label; });
  };
  CHECK(offers("steps up (start)"));
  CHECK(offers("points (right) (start)"));
}

TEST_CASE("a recording goes beside the trace, from the one who records alone") {
  Asked asked;
  const auto session = asked.post("/api/sessions", R"({"clock":"wall","recorder":"me"})", 201);
  const std::string own = "/api/sessions/" + session["id"].get<std::string>();
  const std::string bytes = "\x1A\x45\xDF\xA3 recording";
  const std::string camera = own + "/media?source=camera&type=video/webm&t=0.5&take=0&part=0";
  CHECK(asked.refused(409, camera, bytes) == "somebody else records into this session");
  CHECK(asked.refused(400, camera + "&recorder=me") == "expected bytes of a recording");
  CHECK_FALSE(asked.refused(400, own + "/media?source=camera&type=video/webm&recorder=me", bytes).empty());
  CHECK(asked.post(camera + "&recorder=me", bytes)["accepted"] == bytes.size());
  asked.post(own + "/end?recorder=me");
  CHECK(asked.refused(409, camera + "&recorder=me", bytes) == "the session has ended");
  CHECK(asked.file("session.camera.webm") == bytes);
  CHECK_THAT(asked.file("session.trace.jsonl"),
             Contains(R"("media":[{"file":"session.camera.webm","kind":"video","label":"camera","offset":-0.5}])"));
}

TEST_CASE("a session goes on with an ended one") {
  Asked asked;
  const std::string id = asked.post("/api/sessions", R"({"clock":"events"})", 201)["id"];
  const auto after = compact(Json{{"after", id}});
  CHECK_THAT(asked.refused(400, "/api/sessions", after), Contains("the id of a session that has ended"));
  asked.post("/api/sessions/" + id + "/events", plate);
  asked.post("/api/sessions/" + id + "/end");
  const auto next = asked.post("/api/sessions", after, 201);
  CHECK(next["id"] != id);
  CHECK(next["t"] == 1);  // acts that were under way then go on
  const auto told = asked.post("/api/sessions/" + std::string(next["id"]) + "/events",
                               R"({"t":9,"kind":"speech","text":"Lift it."})");
  CHECK_THAT(compact(told["moves"]), Contains("lift(plate)"));
}

TEST_CASE("the first session goes on with the trace of the command line") {
  const TemporaryFolder before;
  const std::string header = R"({"kind":"trace","version":1,"scene":"place_setting","machine":"interaction"})";
  LiveDefaults defaults;
  defaults.after = before.file("talk.trace.jsonl", header + "\n" + plate + "\n");
  Asked asked(defaults);
  CHECK(asked.get("/api/sessions")["after"] == "talk");
  CHECK(asked.post("/api/sessions", "", 201)["t"] == 1);
  CHECK(!asked.get("/api/sessions").contains("after"));
  CHECK(asked.post("/api/sessions", "", 201)["t"] == 0);
}
