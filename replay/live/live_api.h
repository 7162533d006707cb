// The addresses of live sessions as a function: a request's path and body in, status and JSON out. Knows no server.
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "continua/replay/inspector/inspector_api.h"
#include "continua/replay/live/live_sessions.h"

namespace continua {

/// A session for clients: {"id", "run", "trace", "t", "clock", "speed", "paused", "live", "scene", "machine", "state",
/// "viewers", "gestures", "buttons"}.
Json session_json(const ListedSession& listed, const LiveSessions& sessions);

/// Safe to use from several threads.
class LiveApi {
 public:
  explicit LiveApi(std::shared_ptr<LiveSessions> sessions) : sessions_(std::move(sessions)) {}

  /// "/api/sessions" and "/api/sessions/ID".
  ApiResponse get(std::string_view target);

  /// "/api/sessions" begins one (LiveSessions::start): 201 with session_json. Below "/api/sessions/ID":
  /// "/events" takes events (events_in) and gives {"accepted", "t", "moves"}, with "?batch=NAME" once only; "/pause"
  /// takes {"paused"}; "/end";
  /// "/media?source=camera&type=video/webm&take=0&part=0&t=SECONDS" takes a part of a recording as it is (LiveMedia);
  /// "/save" takes {"name"} and gives 201 {"trace", "runs", "check"}.
  /// 404 unknown, 409 of somebody else's or ended, 429 more than 2000 events a second; nothing is changed by those.
  ApiResponse post(std::string_view target, std::string_view body);

  const LiveSessions& sessions() const { return *sessions_; }

 private:
  ApiResponse events(const ListedSession& listed, const Query& query, std::string_view body);
  static ApiResponse media(const ListedSession& listed, const Query& query, std::string_view body);
  ApiResponse save(const ListedSession& listed, const Json& asked);
  bool admits(const std::string& id, std::size_t events);

  std::shared_ptr<LiveSessions> sessions_;
  std::mutex mutex_;  // guards the members below
  // How many events may come at once, of each session: refilled as time goes on.
  struct Allowance {
    double events = 0;
    std::chrono::steady_clock::time_point at;
  };
  std::map<std::string, Allowance> allowances_;
};

}  // namespace continua
