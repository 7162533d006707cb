#include "continua/replay/server/http_head.h"

#include "support/catch.h"

using namespace continua;

namespace {

// The status that refuses these lines, or 0.
int status_of(const std::string& lines) {
  const auto read = read_head(lines + "\r\n");
  const auto* refused = std::get_if<HttpAnswer>(&read);
  return refused ? refused->status : 0;
}

int status_of_scan(std::string_view text) {
  HeadScan scan;
  const auto found = scan.look(text);
  const auto* refused = std::get_if<HttpAnswer>(&found);
  return refused ? refused->status : 0;
}

}  // namespace

TEST_CASE("a head is read strictly") {
  const std::string get = "GET / HTTP/1.1\r\n";
  struct Case {
    std::string lines;
    int status;
  };
  for (const auto& [lines, status] : {
           Case{get + "Host: a\r\n", 0},
           Case{"GET / HTTP/1.0\r\n", 0},
           Case{"GET / HTTP/2.0\r\n", 505},
           Case{"GET  / HTTP/1.1\r\n", 400},
           Case{"GET /a b HTTP/1.1\r\n", 400},
           Case{"GET http://a/ HTTP/1.1\r\n", 400},
           Case{"GET * HTTP/1.1\r\n", 400},
           Case{"GET /\r\n", 400},
           Case{"BREW / HTTP/1.1\r\n", 405},
           Case{"OPTIONS / HTTP/1.1\r\n", 405},
           Case{get + "Host : a\r\n", 400},
           Case{get + " Host: a\r\n", 400},
           Case{get + "Host\r\n", 400},
           Case{get + "A: b\x01\r\n", 400},
           Case{get + "Host: a\r\nhost: b\r\n", 400},
           Case{get + "Content-Length: 1\r\nContent-Length: 1\r\n", 400},
           Case{get + "Content-Length: -1\r\n", 400},
           Case{get + "Content-Length: +1\r\n", 400},
           Case{get + "Content-Length: 0x1\r\n", 400},
           Case{get + "Content-Length:\r\n", 400},
           Case{get + "Content-Length: 1048576\r\n", 0},
           Case{get + "Content-Length: 1048577\r\n", 413},
           Case{get + "Content-Length: 99999999999999999999999\r\n", 413},
           Case{get + "Transfer-Encoding: chunked\r\n", 411},
           Case{get + "Content-Encoding: br\r\n", 415},
           Case{get + "Content-Encoding: identity\r\n", 0},
       }) {
    INFO(lines);
    CHECK(status_of(lines) == status);
  }
}

TEST_CASE("a head tells what follows") {
  const auto read = read_head(
      "POST /a?b=c HTTP/1.1\r\nhOST:  there \r\nContent-Length: 007\r\nRange: bytes=0-\r\nContinua-Range: x\r\n\r\n");
  const auto& head = std::get<HttpHead>(read);
  CHECK(head.method == "POST");
  CHECK(head.target == "/a?b=c");
  CHECK(head.value("Host") == "there");
  CHECK(head.body == 7);
  CHECK(head.keeps_alive);
  CHECK(head.text() == "POST /a?b=c HTTP/1.1\r\nhOST: there\r\nContinua-Range: bytes=0-\r\nContent-Length: 7\r\n\r\n");
  const auto on_condition =
      std::get<HttpHead>(read_head("GET / HTTP/1.1\r\nRange: bytes=0-\r\nIf-Range: \"a\"\r\n\r\n"));
  CHECK(on_condition.text() == "GET / HTTP/1.1\r\nContent-Length: 0\r\n\r\n");
  CHECK_FALSE(std::get<HttpHead>(read_head("GET / HTTP/1.1\r\nConnection: Close\r\n\r\n")).keeps_alive);
  CHECK_FALSE(std::get<HttpHead>(read_head("GET / HTTP/1.0\r\n\r\n")).keeps_alive);
  CHECK(std::get<HttpHead>(read_head("GET / HTTP/1.0\r\nConnection: keep-alive\r\n\r\n")).keeps_alive);
}

TEST_CASE("the end of a head is found in pieces, or a limit before it") {
  const std::string text = "GET / HTTP/1.1\r\nA: b\r\n\r\nbody";
  HeadScan scan;
  for (std::size_t size = 0; size < text.size() - 4; ++size) {
    const auto found = scan.look(std::string_view(text).substr(0, size));
    REQUIRE_FALSE(std::get<std::optional<std::size_t>>(found).has_value());
  }
  CHECK(std::get<std::optional<std::size_t>>(scan.look(text)) == text.size() - 4);

  CHECK(status_of_scan("GET / HTTP/1.1\n\n") == 400);
  CHECK(status_of_scan("GET /" + std::string(HttpLimits::line, 'a')) == 414);
  CHECK(status_of_scan("GET / HTTP/1.1\r\nA: " + std::string(HttpLimits::line, 'a')) == 431);
  std::string many = "GET / HTTP/1.1\r\n", large = many;
  for (std::size_t i = 0; i <= HttpLimits::header_lines; ++i) many += "A: b\r\n";
  for (int i = 0; i < 5; ++i) large += "A: " + std::string(HttpLimits::line - 100, 'a') + "\r\n";
  CHECK(status_of_scan(many) == 431);
  CHECK(status_of_scan(large) == 431);
}
