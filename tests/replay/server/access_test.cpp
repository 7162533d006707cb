#include "continua/replay/server/access.h"

#include "support/catch.h"

using namespace continua;

namespace {

int status_of(const Access& access, const std::string& target, const std::string& headers) {
  const auto read = read_head("GET " + target + " HTTP/1.1\r\n" + headers + "\r\n");
  const auto refused = access.check(std::get<HttpHead>(read));
  return refused ? refused->status : 0;
}

}  // namespace

TEST_CASE("a request is for this server, and not of a page elsewhere") {
  const Access access("127.0.0.1", 8080, "");
  struct Case {
    const char* headers;
    int status;
  };
  for (const auto& [headers, status] : {
           Case{"Host: 127.0.0.1:8080\r\n", 0},
           Case{"Host: localhost\r\n", 0},
           Case{"Host: [::1]:1\r\n", 0},
           Case{"", 403},
           Case{"Host: evil.example\r\n", 403},
           Case{"Host: 10.0.0.1\r\n", 403},
           Case{"Host: localhost:1\r\nOrigin: http://localhost:1\r\n", 0},
           Case{"Host: localhost:1\r\nOrigin: http://localhost:2\r\n", 403},
           Case{"Host: localhost\r\nOrigin: null\r\n", 403},
           Case{"Host: localhost\r\nOrigin:\r\n", 403},
           Case{"Host: localhost\r\nSec-Fetch-Site: cross-site\r\n", 403},
           Case{"Host: localhost\r\nSec-Fetch-Site: same-site\r\nSec-Fetch-Mode: no-cors\r\n", 403},
           Case{"Host: localhost\r\nSec-Fetch-Site: cross-site\r\nSec-Fetch-Mode: navigate\r\n"
                "Sec-Fetch-Dest: document\r\n",
                0},
       }) {
    INFO(headers);
    CHECK(status_of(access, "/api/runs", headers) == status);
  }
  CHECK(status_of(Access("0.0.0.0", 1, ""), "/", "Host: 10.0.0.1\r\n") == 0);
  CHECK(status_of(Access("0.0.0.0", 1, ""), "/", "Host: evil.example\r\n") == 403);
}

TEST_CASE("a token is asked for, and only the right one counts") {
  const Access access("127.0.0.1", 8080, "abcdefghijklmnop");
  const auto status = [&](const std::string& target, const std::string& headers = "") {
    return status_of(access, target, "Host: localhost\r\n" + headers);
  };
  CHECK(status("/") == 401);
  CHECK(status("/?token=") == 401);
  CHECK(status("/?token=abcdefghijklmno") == 401);
  CHECK(status("/?atoken=abcdefghijklmnop") == 401);
  CHECK(status("/?token=abcdefghijklmnop") == 303);
  CHECK(status("//evil.example/?token=abcdefghijklmnop") == 0);  // no way out
  CHECK(status("/api/runs?token=abcdefghijklmnop") == 0);
  CHECK(status("/", "Authorization: Bearer abcdefghijklmnop\r\n") == 0);
  CHECK(status("/", "Authorization: Basic abcdefghijklmnop\r\n") == 401);
  CHECK(status("/", "Cookie: a=b; continua_8080=abcdefghijklmnop\r\n") == 0);
  CHECK(status("/", "Cookie: continua_8081=abcdefghijklmnop\r\n") == 401);
  CHECK(status_of(access, "/?token=abcdefghijklmnop", "Host: evil.example\r\n") == 403);

  const auto way = access.check(
      std::get<HttpHead>(read_head("GET /r/x?token=abcdefghijklmnop&n=3 HTTP/1.1\r\nHost: localhost\r\n\r\n")));
  REQUIRE(way);
  CHECK(way->headers.front().second == "/r/x?n=3");
}

TEST_CASE("addresses that only this machine can reach") {
  for (const char* address : {"127.0.0.1", "127.1.2.3", "::1", "localhost"}) CHECK(is_loopback(address));
  for (const char* address : {"0.0.0.0", "::", "10.0.0.1", "example.org"}) CHECK_FALSE(is_loopback(address));
  CHECK(new_token().size() == 32);
  CHECK(new_token() != new_token());
}
