// Recordings over HTTP: whole, in parts, and never a file that the trace does not name.
#include "continua/replay/server/media_answer.h"

#include <filesystem>
#include <thread>

#include "continua/replay/server/inspector_server.h"
#include "replay/inspector/inspector_log.h"
#include "replay/server/plain_client.h"

namespace continua {
namespace {

std::string part_of(std::string_view range, std::uint64_t size = 1000) {
  const auto part = wanted_range(range, size);
  return part ? fmt::format("{}-{}", part->from, part->to) : "whole";
}

std::string trace_with(const Json& media) {
  return compact({{"kind", "trace"}, {"version", 1}, {"scene", "s"}, {"machine", "m"}, {"media", media}}) + "\n";
}

// Serves the folder "served" of a scratch folder; a film and a secret lie there and around it.
class MediaServer {
 public:
  MediaServer() {
    folder_.write("served/small.run.jsonl", small_log().text());
    folder_.write("secret.webm", "SECRET");
    folder_.write("served/secret.txt", "SECRET");
    std::filesystem::create_symlink("../secret.webm", std::filesystem::path(folder_.path()) / "served/link.webm");
    std::string film;
    for (int i = 0; i < 2'000'000; ++i) film += static_cast<char>('a' + i % 26);
    folder_.write("served/film.webm", film);
    Json media = Json::array();
    for (const auto* file : {"film.webm", "../secret.webm", "secret.txt", "link.webm", "none.wav", "/etc/hostname"})
      media.push_back({{"file", file}, {"offset", 0.5}, {"label", "A"}});
    folder_.write("served/small", trace_with(media));
    server_.emplace(std::vector<std::string>{folder_.path() + "/served"});
    const auto port = server_->listen();
    REQUIRE(port.ok());
    port_ = *port;
    thread_ = std::thread([this] { server_->run(); });
  }
  ~MediaServer() {
    server_->stop();
    thread_.join();
  }

  std::string get(const std::string& below, const std::string& headers = "", const std::string& method = "GET") const {
    return answer_to(
        fmt::format("{} /api/runs/small/media{} HTTP/1.1\r\nConnection: close\r\nHost: 127.0.0.1:{}\r\n{}\r\n", method,
                    below, port_, headers),
        port_);
  }

 private:
  ScratchFolder folder_;
  std::optional<InspectorServer> server_;
  int port_ = 0;
  std::thread thread_;
};

std::string body_of(const std::string& answer) { return answer.substr(answer.find("\r\n\r\n") + 4); }

}  // namespace

TEST_CASE("a range of bytes is one that the file has, or the whole file is meant") {
  CHECK(part_of("bytes=0-") == "0-1000");
  CHECK(part_of("bytes=10-19") == "10-20");
  CHECK(part_of("bytes=10-5000") == "10-1000");
  CHECK(part_of("bytes=-100") == "900-1000");
  CHECK(part_of("bytes=-5000") == "0-1000");
  CHECK(part_of("bytes=1000-") == "0-0");
  CHECK(part_of("bytes=-0") == "1000-1000");
  for (const auto* other : {"", "bytes", "bytes=", "bytes=-", "bytes=5", "bytes=9-5", "bytes=a-b", "bytes=0-1,5-6",
                            "bytes=+1-2", "bytes= 1-2", "lines=0-1", "bytes=0-99999999999999999999999"})
    CHECK(part_of(other) == "whole");
}

TEST_CASE("recordings are served whole and in parts of a bounded size") {
  const MediaServer server;
  const auto whole = server.get("/0");
  CHECK_THAT(whole, Contains("HTTP/1.1 200"));
  CHECK_THAT(whole, Contains("Content-Type: video/webm"));
  CHECK_THAT(whole, Contains("Accept-Ranges: bytes"));
  CHECK(body_of(whole).size() == 2'000'000);
  const auto part = server.get("/0", "Range: bytes=26-30\r\n");
  CHECK_THAT(part, Contains("HTTP/1.1 206"));
  CHECK_THAT(part, Contains("Content-Range: bytes 26-30/2000000\r\n"));
  CHECK(body_of(part) == "abcde");
  CHECK(body_of(server.get("/0", "Range: bytes=1-\r\n")).size() == most_media_part);
  CHECK_THAT(server.get("/0", "Range: bytes=2000000-\r\n"), Contains("HTTP/1.1 416"));
  CHECK_THAT(server.get("/0", "Range: bytes=2000000-\r\n"), Contains("Content-Range: bytes */2000000\r\n"));
  const auto head = server.get("/0", "", "HEAD");
  CHECK_THAT(head, Contains("Content-Length: 2000000"));
  CHECK(body_of(head).empty());
  // Other answers are whole.
  CHECK_THAT(server.get("", "Range: bytes=0-3\r\n"), Contains("HTTP/1.1 200"));
}

TEST_CASE("recordings outside of the folder, and files that are none, are told and not served") {
  const MediaServer server;
  const auto listed = Json::parse(body_of(server.get("")))["media"];
  REQUIRE(listed.size() == 6);
  CHECK(listed[0] == Json({{"file", "film.webm"},
                           {"kind", "video"},
                           {"label", "A"},
                           {"offset", 0.5},
                           {"type", "video/webm"},
                           {"bytes", 2'000'000}}));
  for (std::size_t i = 1; i < listed.size(); ++i) {
    INFO(compact(listed[i]));
    CHECK(listed[i].contains("problem"));
    const auto answer = server.get(fmt::format("/{}", i));
    CHECK_THAT(answer, Contains("HTTP/1.1 404"));
    CHECK(answer.find("SECRET") == std::string::npos);
  }
  for (const auto* other : {"/6", "/-1", "/", "/0x", "/..%2fsecret.txt", "/../secret.txt", "/secret.txt", "/0/1",
                            "/18446744073709551616", "/%2e%2e"}) {
    INFO(other);
    const auto answer = server.get(other);
    CHECK(answer.find("SECRET") == std::string::npos);
    if (std::string(other) != "/") CHECK_THAT(answer, Contains("HTTP/1.1 404"));
  }
}

}  // namespace continua
