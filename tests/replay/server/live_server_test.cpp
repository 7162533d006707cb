#include <thread>

#include "continua/replay/live/live_sessions.h"
#include "continua/replay/server/inspector_server.h"
#include "replay/server/plain_client.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

using namespace continua;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

std::shared_ptr<LiveSessions> sessions_in(const TemporaryFolder& folder) {
  LiveDefaults defaults;
  defaults.folder = folder.path().string();
  defaults.replay.physics = false;
  const auto created = LiveSessions::create(defaults);
  REQUIRE(created.ok());
  return *created;
}

// A server with live sessions.
class Server {
 public:
  Server() : server_({folder_.path().string()}, sessions_in(folder_)) {
    const auto listening = server_.listen();
    REQUIRE(listening.ok());
    port_ = *listening;
    thread_ = std::thread([this] { server_.run(); });
  }
  ~Server() {
    server_.stop();
    thread_.join();
  }

  std::string ask(const std::string& request, const std::string& headers = "", const std::string& body = "") const {
    return answer_to(request + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n" + headers + "\r\n" + body,
                     port_);
  }
  std::string post(const std::string& target, const std::string& body) const {
    return ask("POST " + target, "Content-Length: " + std::to_string(body.size()) + "\r\n", body);
  }

 private:
  TemporaryFolder folder_;
  InspectorServer server_;
  int port_ = 0;
  std::thread thread_;
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

}  // namespace

TEST_CASE("those who listen get every record, once, and the end") {
  const Server server;
  CHECK_THAT(server.ask("GET /live/session"), Contains("<!doctype html>"));
  CHECK_THAT(server.ask("POST /api/sessions"), StartsWith("HTTP/1.1 201"));
  std::string heard, newest;
  std::thread listening([&] { heard = server.ask("GET /api/live?session=session"); });
  std::thread listening_to_newest([&] { newest = server.ask("GET /api/live"); });
  CHECK_THAT(server.post("/api/sessions/session/events", R"({"t":1,"kind":"speech","text":"The plate."})"),
             Contains("\"accepted\":1"));
  CHECK_THAT(server.ask("GET /api/runs"), Contains("\"id\":\"session\"") && Contains("\"live\":true"));
  // A pause in between, so that it is sure that both have begun to listen.
  while (!Contains("\"viewers\":2").match(server.ask("GET /api/sessions/session"))) std::this_thread::yield();
  CHECK_THAT(server.ask("POST /api/sessions/session/end"), Contains("\"live\":false"));
  listening.join();
  listening_to_newest.join();
  for (const auto& stream : {heard, newest}) {
    CHECK_THAT(stream, Contains("text/event-stream") && Contains("event: clock") && Contains("event: ended"));
    CHECK_THAT(stream, Contains("id: 0\nevent: record\ndata: {\"kind\":\"run\"") && Contains("\"kind\":\"end\""));
    CHECK(count(stream, "\nid: ") == count(stream, "event: record"));
  }
  const auto records = count(heard, "event: record");
  CHECK(count(newest, "event: record") == records);

  const auto resumed = server.ask("GET /api/live?session=session", "Last-Event-ID: 4\r\n");
  CHECK_THAT(resumed, Contains("id: 5\n") && !Contains("id: 4\n"));
  CHECK(count(resumed, "event: record") == records - 5);
  CHECK(count(server.ask("GET /api/live?session=session&after=4"), "event: record") == records - 5);
  CHECK_THAT(server.ask("GET /api/live?session=other"), StartsWith("HTTP/1.1 404"));
}

TEST_CASE("live sessions are nobody's from elsewhere") {
  const Server server;
  const std::string elsewhere = "Origin: http://example.org\r\nContent-Length: 0\r\n";
  CHECK_THAT(server.ask("POST /api/sessions", elsewhere), StartsWith("HTTP/1.1 403"));
  CHECK_THAT(server.ask("GET /api/sessions"), Contains("\"sessions\":[]"));
}
