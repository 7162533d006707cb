#include "continua/replay/server/inspector_server.h"
#include <thread>

#include "replay/inspector/inspector_log.h"
#include "replay/server/plain_client.h"
#include "support/catch.h"

using namespace continua;
using Catch::Matchers::StartsWith;

namespace {

// A server with one run.
class Server {
 public:
  Server() : server_({folder_.write("small.run.jsonl", small_log().text())}) {
    const auto port = server_.listen();
    REQUIRE(port.ok());
    port_ = *port;
    thread_ = std::thread([this] { server_.run(); });
  }
  ~Server() {
    server_.stop();
    thread_.join();
  }

  std::string ask(const std::string& method, const std::string& target, const std::string& headers) const {
    return answer_to(method + " " + target + " HTTP/1.1\r\nConnection: close\r\n" + headers + "\r\n", port_);
  }
  std::string host() const { return "Host: 127.0.0.1:" + std::to_string(port_) + "\r\n"; }
  std::string get(const std::string& target, const std::string& headers = "") const {
    return ask("GET", target, host() + headers);
  }

 private:
  ScratchFolder folder_;
  InspectorServer server_;
  int port_ = 0;
  std::thread thread_;
};

std::string header_of(const std::string& answer, const std::string& name) {
  const auto from = answer.find("\r\n" + name + ": ");
  if (from == std::string::npos) return {};
  const auto begin = from + name.size() + 4;
  return answer.substr(begin, answer.find("\r\n", begin) - begin);
}

}  // namespace

TEST_CASE("the page and the API are served") {
  const Server server;
  const auto page = server.get("/");
  CHECK_THAT(page, StartsWith("HTTP/1.1 200"));
  CHECK_THAT(page, Contains("<!doctype html>"));
  CHECK_THAT(header_of(page, "Content-Security-Policy"), Contains("default-src 'none'"));
  CHECK(server.get("/r/small?n=3").substr(0, 12) == "HTTP/1.1 200");
  CHECK(server.get("/diff/small/other?h=1").substr(0, 12) == "HTTP/1.1 200");
  CHECK_THAT(header_of(server.get("/main.js"), "Content-Type"), StartsWith("text/javascript"));
  CHECK_THAT(server.get("/api/runs/small"), Contains("\"utterances\":1"));
  CHECK_THAT(server.get("/../../etc/passwd"), StartsWith("HTTP/1.1 4"));
  CHECK_THAT(server.get("/nothing.js"), StartsWith("HTTP/1.1 404"));
}

TEST_CASE("assets are compressed where that is understood, and not sent twice") {
  const Server server;
  const auto packed = server.get("/style.css", "Accept-Encoding: gzip\r\n");
  CHECK(header_of(packed, "Content-Encoding") == "gzip");
  const auto plain = server.get("/style.css");
  CHECK(header_of(plain, "Content-Encoding").empty());
  CHECK(packed.size() < plain.size());
  const auto etag = header_of(plain, "ETag");
  REQUIRE_FALSE(etag.empty());
  CHECK_THAT(server.get("/style.css", "If-None-Match: " + etag + "\r\n"), StartsWith("HTTP/1.1 304"));
}

TEST_CASE("other hosts, other origins, writing and large bodies are refused") {
  const Server server;
  CHECK_THAT(server.ask("GET", "/api/runs", "Host: example.org\r\n"), StartsWith("HTTP/1.1 403"));
  CHECK_THAT(server.ask("GET", "/api/runs", "Host: localhost:1\r\n"), StartsWith("HTTP/1.1 200"));
  CHECK_THAT(server.get("/api/runs", "Origin: http://example.org\r\n"), StartsWith("HTTP/1.1 403"));
  CHECK_THAT(server.get("/api/runs", "Origin: null\r\n"), StartsWith("HTTP/1.1 403"));
  CHECK_THAT(server.ask("POST", "/api/runs", server.host() + "Content-Length: 0\r\n"), StartsWith("HTTP/1.1 405"));
  CHECK_THAT(server.ask("POST", "/api/sessions", server.host() + "Content-Length: 0\r\n"), StartsWith("HTTP/1.1 405"));
  CHECK_THAT(server.ask("POST", "/api/sessions", server.host() + "Content-Length: 99999999\r\n"),
             StartsWith("HTTP/1.1 413"));
}

TEST_CASE("notes and what-if can be written, by those who may") {
  const Server server;
  const auto send = [&](const std::string& method, const std::string& target, const std::string& body,
                        const std::string& headers = "Content-Type: application/json\r\n") {
    return server.ask(method, target,
                      server.host() + headers + "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body);
  };
  const std::string notes = R"({"notes":[{"id":"a","n":3,"text":"Here."}],"version":""})";
  const std::string elsewhere = "Content-Type: application/json\r\nOrigin: http://example.org\r\n";
  CHECK_THAT(send("PUT", "/api/runs/small/notes", notes, elsewhere), StartsWith("HTTP/1.1 403"));
  CHECK_THAT(send("PUT", "/api/runs/small/notes", notes, "Content-Type: text/plain\r\n"), StartsWith("HTTP/1.1 415"));
  CHECK_THAT(send("PUT", "/api/runs/small/notes", notes, ""), StartsWith("HTTP/1.1 415"));
  CHECK_THAT(send("PUT", "/api/runs/small/notes", notes), StartsWith("HTTP/1.1 200"));
  CHECK_THAT(server.get("/api/runs/small/notes"), Contains("Here."));
  CHECK_THAT(send("PUT", "/api/runs/small/notes", notes), StartsWith("HTTP/1.1 409"));
  CHECK_THAT(send("POST", "/api/runs/small/notes", notes), StartsWith("HTTP/1.1 405"));
  CHECK_THAT(send("PUT", "/api/runs/small/stack", notes), StartsWith("HTTP/1.1 405"));
  CHECK_THAT(send("DELETE", "/api/runs/small/notes", ""), StartsWith("HTTP/1.1 405"));
  const std::string what_if = R"({"run":"small"})";
  CHECK_THAT(send("POST", "/api/what-if", what_if, elsewhere), StartsWith("HTTP/1.1 403"));
  CHECK_THAT(send("POST", "/api/what-if", what_if, "Content-Type: text/plain\r\n"), StartsWith("HTTP/1.1 415"));
  CHECK_THAT(send("POST", "/api/what-if", what_if), StartsWith("HTTP/1.1 400"));
  CHECK_THAT(send("PUT", "/api/what-if", what_if), StartsWith("HTTP/1.1 405"));
  CHECK_THAT(send("PUT", "/api/runs/small/notes", std::string((1 << 20) + 1, ' ')), StartsWith("HTTP/1.1 413"));
}

TEST_CASE("a port in use is an error with a sentence") {
  InspectorServer first({});
  const auto port = first.listen();
  REQUIRE(port.ok());
  InspectorServer second({});
  const auto refused = second.listen("127.0.0.1", *port);
  REQUIRE_FALSE(refused.ok());
  CHECK_THAT(refused.error().text(), Contains("in use") && Contains("--port "));
  CHECK_THAT(InspectorServer({}).listen("203.0.113.1", 0).error().text(), Contains("cannot be listened on"));
}
