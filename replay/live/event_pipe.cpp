#include "continua/replay/live/event_pipe.h"

#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <thread>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/replay/live/live_tail.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/terminal/terminal.h"

namespace continua {
namespace {

constexpr int look_every_ms = 100;  // whether to stop
constexpr std::size_t longest_line = std::size_t{1} << 20;

// The lines of standard input as they come.
class InputLines {
 public:
  explicit InputLines(const std::atomic<bool>& stop) : stop_(stop) {}

  std::optional<std::string> next() {
    for (;;) {
      if (const auto end = rest_.find('\n', looked_); end != std::string::npos) {
        std::string line = rest_.substr(0, end);
        rest_.erase(0, end + 1);
        looked_ = 0;
        return line;
      }
      looked_ = rest_.size();
      if (looked_ > longest_line || !read_more()) {
        looked_ = 0;
        if (rest_.empty()) return std::nullopt;
        return std::exchange(rest_, {});
      }
    }
  }

 private:
  bool read_more() {
    while (!stop_) {
      pollfd input{STDIN_FILENO, POLLIN, 0};
      if (::poll(&input, 1, look_every_ms) == 0) continue;
      std::array<char, 65536> part;
      const auto size = ::read(STDIN_FILENO, part.data(), part.size());
      if (size <= 0) return false;
      rest_.append(part.data(), static_cast<std::size_t>(size));
      return true;
    }
    return false;
  }

  const std::atomic<bool>& stop_;
  std::string rest_;
  std::size_t looked_ = 0;
};

void print_moves(std::shared_ptr<const LiveSession> session) {
  LiveTail tail(std::move(session), 0);
  while (!tail.is_done()) {
    for (const auto& line : tail.next(std::chrono::milliseconds(look_every_ms))) {
      const auto kind = member_in(line, "kind");
      if (kind.size() > 2 && is_avatars_move(kind.substr(1, kind.size() - 2))) put(stdout, line + "\n");
    }
    // A consumer that has gone is no reason not to record.
    if (std::fflush(stdout) != 0 && errno == EPIPE) return std::clearerr(stdout);
  }
}

// The request in a trace's header; an empty one for any other line.
Json asked_by(const Json& line) {
  Json asked = Json::object();
  for (const char* field : {"scene", "machine", "seed", "perspective", "objects"})
    if (line.contains(field)) asked[field] = line[field];
  return asked;
}

bool is_header(const Json& line) { return line.is_object() && line.contains("kind") && line["kind"] == "trace"; }

// The session that lines go to, and the threads that print its output.
class Piped {
 public:
  explicit Piped(LiveSessions& sessions) : sessions_(sessions) {}
  ~Piped() {
    if (!printing_.joinable()) return;
    listed_.session->end();
    printing_.join();
  }
  Piped(const Piped&) = delete;
  Piped& operator=(const Piped&) = delete;

  bool begun() const { return listed_.session != nullptr; }

  Outcome begin(Json asked) {
    // The command line counts.
    const auto& defaults = sessions_.defaults();
    if (!defaults.scene.empty()) asked.erase("scene");
    if (!defaults.machine.empty()) asked.erase("machine");
    if (defaults.replay.seed) asked.erase("seed");
    // Who writes events goes on while the session is loaded.
    auto started = sessions_.start(asked, true, std::chrono::steady_clock::now());
    if (const auto* refusal = std::get_if<LiveRefusal>(&started)) return Error{"standard input", refusal->sentence};
    listed_ = std::get<ListedSession>(started);
    if (const auto& warning = listed_.session->setting().warning) report_warning(*warning);
    printing_ = std::thread([session = listed_.session] { print_moves(session); });
    return std::nullopt;
  }

  Outcome take(Json event) {
    const auto reply = listed_.session->receive({std::move(event)});
    return reply ? Outcome() : Outcome(reply.error());
  }

  /// Why it ended, if not because it was told to.
  std::optional<Error> broke() const { return listed_.session->audience().state().broke; }

  const ListedSession& end() {
    listed_.session->end();
    printing_.join();
    return listed_;
  }

 private:
  LiveSessions& sessions_;
  ListedSession listed_;
  std::thread printing_;
};

}  // namespace

bool is_piped() {
  struct stat input {};
  return ::fstat(STDIN_FILENO, &input) == 0 &&
         (S_ISFIFO(input.st_mode) || S_ISREG(input.st_mode) || S_ISSOCK(input.st_mode));
}

Result<PipeSummary> pipe_events(LiveSessions& sessions, bool begin_empty, const std::atomic<bool>& stop) {
  PipeSummary told;
  Piped piped(sessions);
  InputLines lines(stop);
  std::size_t number = 0;
  while (auto line = lines.next()) {
    ++number;
    if (line->find_first_not_of(" \t\r") == std::string::npos) continue;
    auto json = parse_json_line(*line, "standard input", number);
    const bool header = json && is_header(*json);
    if (!piped.begun())
      if (const auto problem = piped.begin(header ? asked_by(*json) : Json::object())) return *problem;
    if (header && number == 1) continue;
    const auto problem = json ? piped.take(*std::move(json)) : Outcome(json.error());
    ++(problem ? told.refused : told.events);
    if (problem) report({json ? fmt::format("standard input:{}", number) : "", problem->text()});
    if (piped.broke()) break;
  }
  if (!piped.begun() && begin_empty && !stop)
    if (const auto problem = piped.begin(Json::object())) return *problem;
  if (!piped.begun()) return told;
  told.session = piped.end();
  told.summary = told.session.session->summary();
  told.broke = piped.broke().has_value();
  return told;
}

}  // namespace continua
