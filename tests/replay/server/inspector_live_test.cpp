#include <arpa/inet.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <fstream>
#include <memory>
#include <thread>

#include "continua/replay/server/inspector_server.h"
#include "replay/inspector/inspector_log.h"
#include "support/catch.h"

using namespace continua;

namespace {

// A server over one log that is cut in half, to be written on.
struct Growing {
  Growing() {
    const auto listening = server.listen();
    REQUIRE(listening.ok());
    port = *listening;
    thread = std::thread([this] { server.run(); });
  }
  ~Growing() {
    server.stop();
    thread.join();
  }
  void write(std::size_t from, std::size_t to) const {
    std::ofstream(path, std::ios::binary | std::ios::app) << text.substr(from, to - from);
  }

  const std::string text = small_log().text();
  const std::size_t half = text.find('\n', text.size() / 2) + 1;
  ScratchFolder folder;
  const std::string path = folder.write("growing.run.jsonl", text.substr(0, half));
  InspectorServer server{{path}};
  int port = 0;
  std::thread thread;
};

class Stream {
 public:
  explicit Stream(int port, const std::string& id = "growing", const std::string& more = "")
      : line_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    timeval patience{20, 0};
    ::setsockopt(line_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    REQUIRE(::connect(line_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0);
    const auto request =
        "GET /api/live?run=" + id + " HTTP/1.1\r\nHost: 127.0.0.1:" + std::to_string(port) + "\r\n" + more + "\r\n";
    REQUIRE(::send(line_, request.data(), request.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(request.size()));
  }
  ~Stream() { ::close(line_); }
  Stream(const Stream&) = delete;
  Stream& operator=(const Stream&) = delete;

  // Reads on until the received text contains `what`; false if it ends before.
  bool reads(const std::string& what) {
    char block[4096];
    while (came_.find(what) == std::string::npos) {
      const auto got = ::recv(line_, block, sizeof block, 0);
      if (got <= 0) return false;
      came_.append(block, static_cast<std::size_t>(got));
    }
    return true;
  }
  const std::string& came() const { return came_; }

 private:
  int line_;
  std::string came_;
};

}  // namespace

TEST_CASE("a run that is being written is told of as it grows, until it is complete") {
  const Growing run;
  Stream stream(run.port);
  REQUIRE(stream.reads("\n\n"));
  CHECK_THAT(stream.came(), Contains("Content-Type: text/event-stream"));
  CHECK_THAT(stream.came(), Contains("event: grown\ndata: {\"records\":"));
  CHECK_THAT(stream.came(), !Contains("\"records\":22"));
  const auto last = run.text.find('\n', run.half) + 1;
  run.write(run.half, last);
  REQUIRE(stream.reads("\"complete\":false,\"live\":true}\n\n\r\n"));
  run.write(last, run.text.size());
  REQUIRE(stream.reads("{\"records\":22,\"t\":10.0,\"complete\":true,\"live\":false}"));
  CHECK(stream.reads("\r\n0\r\n"));
}

TEST_CASE("a server of a folder without runs ends when it is told to") {
  const ScratchFolder folder;
  InspectorServer server{{folder.path()}};
  const auto port = server.listen();
  REQUIRE(port.ok());
  std::thread thread([&server] { server.run(); });
  REQUIRE(Stream(*port, "none").reads("\r\n\r\n"));
  server.stop();
  thread.join();
}

TEST_CASE("what cannot be followed is said") {
  const Growing run;
  Stream none(run.port, "none"), strange(run.port, "growing", "Origin: http://elsewhere.example\r\n");
  REQUIRE(none.reads("\r\n\r\n"));
  CHECK_THAT(none.came(), Contains(" 404 "));
  REQUIRE(strange.reads("\r\n\r\n"));
  CHECK_THAT(strange.came(), Contains(" 403 "));
}

TEST_CASE("streams are few, leave room for others, and end with the server") {
  auto run = std::make_unique<Growing>();
  std::vector<std::unique_ptr<Stream>> streams;
  for (int i = 0; i < 64; ++i) {
    streams.push_back(std::make_unique<Stream>(run->port));
    REQUIRE(streams.back()->reads("event: grown"));
  }
  {
    Stream refused(run->port);
    REQUIRE(refused.reads("\r\n\r\n"));
    CHECK_THAT(refused.came(), Contains(" 503 "));
  }
  // One that goes makes room.
  streams.pop_back();
  bool taken = false;
  for (int tries = 0; tries < 100 && !taken; ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    Stream next(run->port);
    REQUIRE(next.reads("\r\n\r\n"));
    taken = next.came().find(" 200 ") != std::string::npos;
  }
  CHECK(taken);
  run.reset();
  CHECK_FALSE(streams.front()->reads("never written"));
}
