#include "continua/replay/live/live_session.h"

#include <filesystem>
#include <sstream>
#include <thread>

#include "continua/core/random.h"
#include "continua/replay/live/live_trace.h"
#include "continua/replay/session/session_loop.h"
#include "continua/replay/trace/trace_file.h"
#include "replay/played.h"
#include "support/catch.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

using namespace continua;
using namespace std::chrono_literals;

namespace {

const auto traces = std::filesystem::path(source_dir()) / "traces";

LiveOptions options_in(const TemporaryFolder& folder, std::optional<LiveTiming> timing, bool physics = false) {
  LiveOptions options;
  options.trace_path = folder.at("live.trace.jsonl");
  options.log_path = folder.at("live.run.jsonl");
  options.header.scene = "place_setting";
  options.header.machine = "interaction";
  options.replay.physics = physics;
  options.timing = timing;
  return options;
}

std::shared_ptr<LiveSession> started(LiveOptions options) {
  auto session = LiveSession::start(std::move(options));
  if (!session) FAIL(session.error().text());
  return *session;
}

LiveReply sent(LiveSession& session, const std::string& event) {
  const auto reply = session.receive({Json::parse(event)});
  if (!reply) FAIL(reply.error().text());
  return *reply;
}

std::string content(const std::string& path) { return read_file(path).value(); }

// A log without the digest of the trace, which a live session does not know, and without the digests that depend on it.
std::vector<std::string> comparable(const std::string& log) {
  std::vector<std::string> lines;
  std::istringstream stream(log);
  for (std::string line; std::getline(stream, line);) {
    auto record = Json::parse(line);
    if (record["kind"] == "block" || record["kind"] == "end") record.erase("digest");
    if (record["kind"] == "run") record["trace"] = nullptr;
    lines.push_back(compact(record));
  }
  return lines;
}

std::string replayed(const std::string& trace, bool physics) {
  ReplayOptions options;
  options.physics = physics;
  auto session = Session::load(trace, options);
  if (!session) FAIL(session.error().text());
  std::ostringstream log;
  session->run(log);
  return log.str();
}

std::vector<std::string> said_in(const std::string& log) {
  std::vector<std::string> said;
  std::istringstream stream(log);
  for (std::string line; std::getline(stream, line);)
    if (const auto record = Json::parse(line); record["kind"] == "utterance") said.push_back(record["text"]);
  return said;
}

using Texts = std::vector<std::string>;

}  // namespace

TEST_CASE("how time is cut into pieces makes no difference to a run") {
  const auto [name, physics] = GENERATE(table<std::string, bool>({{"paper/dialogue_gesture", false},
                                                                  {"paper/one_shot_learning", false},
                                                                  {"talk/staircase", false},
                                                                  {"paper/correction", true}}));
  const auto path = (traces / (name + ".trace.jsonl")).string();
  ReplayOptions options;
  options.physics = physics;
  auto session = Session::load(path, options);
  REQUIRE(session.ok());
  std::ostringstream whole, cut;
  session->run(whole);
  Random random(7);
  const Watch nobody;
  auto loop = session->begin(nobody, cut);
  REQUIRE(loop.ok());
  const auto events = session->trace().events();
  REQUIRE(events.ok());
  for (const auto& event : *events) {
    while ((*loop)->now() < event.t && random.uniform() < 0.9)
      (*loop)->wait_until(
          std::min(event.t, (*loop)->now() + SimTime{static_cast<std::int64_t>(random.uniform() * 7e4)}));
    (*loop)->wait_until(event.t);
    (*loop)->take(event);
  }
  session->end(**loop);
  CHECK(cut.str() == whole.str());
}

TEST_CASE("a trace told event by event gives the run of its replay") {
  const std::string name = GENERATE("paper/dialogue_gesture", "paper/region_place", "corner/alternatives");
  const auto trace = read_trace((traces / (name + ".trace.jsonl")).string());
  REQUIRE(trace.ok());
  const TemporaryFolder folder;
  auto options = options_in(folder, {});
  options.header = trace->header;
  const auto session = started(options);
  std::vector<Json> events;
  for (const auto& event : trace->events) events.push_back(event.json);
  REQUIRE(session->receive(events).ok());
  session->end();
  CHECK(session->audience().state().timing == LiveTiming::events);
  const auto log = content(options.log_path);
  CHECK(comparable(log) == comparable(replayed(options.trace_path, false)));
  const auto decisions = [](const std::string& text) {
    return Json::parse(text.substr(text.rfind('\n', text.size() - 2) + 1))["decisions"];
  };
  CHECK(decisions(log) == decisions(replayed(trace->name, false)));
}

TEST_CASE("what was live replays to the same bytes") {
  const TemporaryFolder folder;
  auto options = options_in(folder, LiveTiming::wall, true);
  options.speed = 4;
  const auto session = started(options);
  sent(*session, R"({"kind":"speech","text":"The plate."})");
  std::this_thread::sleep_for(130ms);
  for (int i = 0; i < 12; ++i) {
    sent(*session, R"({"kind":"pointing","hand":"right","target":[-0.1,-0.15]})");
    std::this_thread::sleep_for(10ms);
  }
  sent(*session, R"({"kind":"speech","text":"Put it there."})");
  std::this_thread::sleep_for(700ms);
  sent(*session, R"({"kind":"speech","text":"Stop."})");
  session->end();
  const auto log = content(options.log_path);
  CHECK(comparable(log) == comparable(replayed(options.trace_path, true)));
  CHECK(said_in(log) == Texts{"Okay, go on.", "Okay.", "Okay."});
  CHECK(session->summary().end.seconds() > 3);
}

TEST_CASE("a session that goes on with an ended one replays to the same bytes, acts under way included") {
  const TemporaryFolder folder;
  const auto first = started(options_in(folder, LiveTiming::events, true));
  sent(*first, R"({"kind":"speech","text":"Put the plate in front of you.","t":1})");
  sent(*first, R"({"kind":"clock","t":1.7})");
  first->end();
  auto options = options_in(folder, LiveTiming::events, true);
  const auto before = read_before(options.trace_path, folder.path().string());
  REQUIRE(before.ok());
  options.header = before->header;
  options.trace_path = folder.at("more.trace.jsonl");
  options.log_path = folder.at("more.run.jsonl");
  const auto started_after = LiveSession::start(options, before->events);
  REQUIRE(started_after.ok());
  const auto more = *started_after;
  CHECK(more->audience().state().t == SimTime::from_seconds(1.7));
  sent(*more, R"({"kind":"speech","text":"Stop.","t":2})");
  more->end();
  const auto log = content(options.log_path);
  CHECK(comparable(log) == comparable(replayed(options.trace_path, true)));
  CHECK(said_in(log).size() == 2);
}

TEST_CASE("what comes late goes by its own time within the window, and does nothing later than that") {
  const TemporaryFolder folder;
  const auto options = options_in(folder, LiveTiming::events);
  const auto session = started(options);
  sent(*session, R"({"t":1,"kind":"speech","text":"The plate."})");
  sent(*session, R"({"t":3,"kind":"speech","text":"Put it there."})");
  sent(*session, R"({"t":3.9,"kind":"clock"})");
  sent(*session, R"({"t":2.2,"kind":"gesture","name":"point","phase":"stroke","target":[-0.1,-0.15]})");
  sent(*session, R"({"t":6,"kind":"clock"})");
  sent(*session, R"({"t":2,"kind":"speech","text":"Never mind."})");
  session->end();
  const auto log = content(options.log_path);
  CHECK_THAT(log, Catch::Matchers::Contains(R"json("program":"put(plate, <-0.1, -0.15, 0>)","status":"asked")json"));
  CHECK_THAT(log, Catch::Matchers::Contains(R"("reason":"it came 4 s late; expected within 2 s")"));
  CHECK(said_in(log) == Texts{"Okay, go on.", "Okay."});
  CHECK(comparable(log) == comparable(replayed(options.trace_path, false)));
}

TEST_CASE("time may have begun before the session was loaded") {
  const TemporaryFolder folder;
  auto options = options_in(folder, LiveTiming::wall);
  options.began = std::chrono::steady_clock::now() - 60s;
  const auto session = started(std::move(options));
  CHECK(sent(*session, R"({"kind":"mark","text":"now"})").t.seconds() >= 60);
}

TEST_CASE("a pause lets time stand still, and what is said in it counts then") {
  const TemporaryFolder folder;
  const auto session = started(options_in(folder, LiveTiming::wall));
  REQUIRE_FALSE(session->pause(true));
  const auto t = session->audience().state().clock.at(std::chrono::steady_clock::now());
  std::this_thread::sleep_for(40ms);
  CHECK(sent(*session, R"({"kind":"speech","text":"The plate."})").t == t);
  REQUIRE_FALSE(session->pause(false));
  std::this_thread::sleep_for(5ms);
  CHECK(session->audience().state().clock.at(std::chrono::steady_clock::now()) > t);
  const auto by_events = started([&] {
    auto options = options_in(folder, LiveTiming::events);
    options.trace_path += "2", options.log_path += "2";
    return options;
  }());
  CHECK(by_events->pause(true));
}

TEST_CASE("a recorder who goes away and does not come back ends the session after a while") {
  const auto lives_on = [](bool comes_back) {
    const TemporaryFolder folder;
    auto options = options_in(folder, LiveTiming::wall);
    options.grace = 200ms;
    const auto live = started(options);
    live->away(true);
    if (comes_back) live->away(false);
    std::this_thread::sleep_for(1500ms);
    return live->audience().state().live;
  };
  CHECK(lives_on(true));
  CHECK_FALSE(lives_on(false));
}

TEST_CASE("an event that cannot be used changes nothing, nor do those with it") {
  const TemporaryFolder folder;
  const auto options = options_in(folder, LiveTiming::events);
  const auto session = started(options);
  sent(*session, R"({"t":1,"kind":"speech","text":"The plate."})");
  const auto trace = content(options.trace_path), log = content(options.log_path);
  const auto refused = session->receive(
      {Json::parse(R"({"t":2,"kind":"speech","text":"Grasp it."})"), Json::parse(R"({"t":2,"kind":"speech"})")});
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().text() == "event 2: speech has no 'text' or 'alternatives'");
  CHECK(content(options.trace_path) == trace);
  CHECK(content(options.log_path) == log);
  CHECK(session->audience().state().t.seconds() == 1);
}

TEST_CASE("a recogniser's output is taken as the events that are known by it, and replays to the same bytes") {
  const TemporaryFolder folder;
  const auto session = started(options_in(folder, LiveTiming::events));
  const auto frame = [](int ms, const char* gesture) {
    return fmt::format(
        R"({{"kind":"recognised","from":"mediapipe","parts":[{{"timestamp_ms":{},"gestures":[[{{"categoryName":"{}"}}]]}}]}})",
        ms, gesture);
  };
  for (int ms = 1000; ms <= 1500; ms += 100) CHECK(sent(*session, frame(ms, "stop")).accepted == 1);
  const auto refused =
      session->receive({Json::parse(frame(1600, "stop")), Json::parse(R"({"kind":"recognised","from":"it"})")});
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().text() == R"(recognised: 'from' is "it"; expected one of whisper, vosk, mediapipe)");
  sent(*session, R"({"kind":"recognised","from":"mediapipe","end":true})");
  session->end();
  const auto trace = content(folder.at("live.trace.jsonl"));
  CHECK(trace.find(R"("kind":"gesture","name":"stop","phase":"start")") != std::string::npos);
  CHECK(trace.find(R"("kind":"gesture","name":"stop","phase":"stop")") != std::string::npos);
  CHECK(trace.find("recognised") == std::string::npos);
  CHECK(std::count(trace.begin(), trace.end(), '\n') == 4);  // header, two events, end
  CHECK(comparable(content(folder.at("live.run.jsonl"))) == comparable(replayed(folder.at("live.trace.jsonl"), false)));
}

TEST_CASE("the end is clean, whoever brings it about, and nothing comes after it") {
  const TemporaryFolder folder;
  const auto options = options_in(folder, LiveTiming::events);
  SECTION("its event") {
    const auto session = started(options);
    CHECK(sent(*session, R"({"t":2,"kind":"end"})").t.seconds() == 2);
    CHECK_FALSE(session->audience().state().live);
    CHECK_FALSE(session->receive({Json::parse(R"({"kind":"speech","text":"a"})")}).ok());
    CHECK(session->pause(true));
    session->end();
  }
  SECTION("a request") {
    const auto session = started(options);
    sent(*session, R"({"t":2,"kind":"clock"})");
    session->end();
    session->end();
  }
  SECTION("nobody holds it any more") { sent(*started(options), R"({"t":2,"kind":"clock"})"); }
  const auto trace = read_trace(options.trace_path);
  REQUIRE(trace.ok());
  REQUIRE(trace->events.size() == 1);
  CHECK(trace->events[0].t.seconds() == 2);
  CHECK(comparable(content(options.log_path)) == comparable(replayed(options.trace_path, false)));
}

TEST_CASE("moves are told with the event that they come of, and acts as they end") {
  const TemporaryFolder folder;
  const auto session = started(options_in(folder, LiveTiming::events));
  const auto kinds = [&](const std::string& event) {
    Texts told;
    for (const auto& move : sent(*session, event).moves) told.push_back(Json::parse(move)["kind"]);
    return told;
  };
  CHECK(kinds(R"({"t":1,"kind":"speech","text":"The plate."})") == Texts{"gesture", "utterance"});
  CHECK(kinds(R"({"t":2,"kind":"clock"})").empty());
}

TEST_CASE("a session whose files can no longer be written says so and ends") {
  const TemporaryFolder folder;
  auto options = options_in(folder, LiveTiming::events);
  options.log_path = "/dev/full";
  const auto session = started(options);
  const auto refused = session->receive({Json::parse(R"({"t":1,"kind":"speech","text":"The plate."})")});
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().text() == "/dev/full: cannot be written any further; the session has ended");
  CHECK_FALSE(session->audience().state().live);
}

TEST_CASE("a session whose log is full ends, whole, and says so") {
  const TemporaryFolder folder;
  auto options = options_in(folder, LiveTiming::events);
  options.most_log_bytes = 1;
  const auto session = started(options);
  auto refused = session->receive({Json::parse(R"({"t":1,"kind":"speech","text":"The plate."})")});
  if (refused) refused = session->receive({Json::parse(R"({"t":2,"kind":"speech","text":"The cup."})")});
  REQUIRE_FALSE(refused.ok());
  CHECK(refused.error().text().find("the most of a live session") != std::string::npos);
  CHECK_FALSE(session->audience().state().live);
  CHECK(content(options.log_path).find("\"kind\":\"end\"") != std::string::npos);
}

TEST_CASE("a session that cannot be begun leaves no files") {
  const TemporaryFolder folder;
  auto options = options_in(folder, {});
  options.header.scene = "no_such_scene";
  CHECK_FALSE(LiveSession::start(options).ok());
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("a session that cannot be begun leaves what was in the place of its log") {
  const TemporaryFolder folder;
  auto options = options_in(folder, {});
  options.log_path = folder.file("before.run.jsonl", "an older run");
  options.header.scene = "no_such_scene";
  CHECK_FALSE(LiveSession::start(options).ok());
  CHECK(std::filesystem::exists(options.log_path));
}
