// The live sessions of a program: a request becomes one, by its id.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "continua/replay/live/live_session.h"

namespace continua {

/// The common settings of sessions.
struct LiveDefaults {
  std::string folder = ".";             ///< of their traces and logs
  std::string name = "session";         ///< of each; where it is taken a number goes after it
  std::string ending = ".trace.jsonl";  ///< of a trace's file
  std::string after;                    ///< a trace with which the first session goes on; empty: it begins anew
  std::string scene, machine;           ///< where none is asked for; empty: those of knowledge/live.json
  ReplayOptions replay;                 ///< seed, knowledge, physics
  std::optional<LiveTiming> timing;
  double speed = 1;
  bool durable = false;                                  ///< LiveOptions::durable
  std::string tests = "tests";                           ///< folder in which sessions are saved as tests
  std::size_t most_begun = 1000;                         ///< each leaves two files, and a row of the list
  std::function<void(const std::string& sentence)> say;  ///< to whoever started the program; may be empty
};

/// Something asked for cannot be had; `status` is that of HTTP.
struct LiveRefusal {
  int status = 400;
  std::string sentence;
};

/// Whether the name is fit for a file of any folder: 1 to 64 letters, digits, _ or -.
bool is_file_name(const std::string& name);

/// A session with its state for a list.
struct ListedSession {
  std::string id;
  std::string run;  ///< by which its log is known to others; empty if it is to none
  std::shared_ptr<LiveSession> session;
};

/// Safe to use from several threads.
class LiveSessions {
 public:
  /// Makes a log known to others by the id that it gives; may be empty.
  using Publish = std::function<std::string(const std::string& name, const std::string& log_path)>;

  /// Errors: there is no knowledge.
  static Result<std::shared_ptr<LiveSessions>> create(LiveDefaults defaults);
  /// From now on. REQUIRES that none has been begun.
  void publish_by(Publish publish) { publish_ = std::move(publish); }
  /// Ends all of them.
  ~LiveSessions() { end(); }

  /// {"scene", "machine", "seed", "perspective", "objects", "physics", "clock", "speed", "name", "recorder", "after"},
  /// each of which may be left out; the first five are as in a trace's header, which will do as well. Unless
  /// `any_file`, scene and machine are among the names of setup(). `after`: the id of an ended session, with which the
  /// new one goes on, in its world. `began`: when its time began, if it goes by the wall's clock; none: when it is
  /// loaded.
  std::variant<ListedSession, LiveRefusal> start(const Json& asked, bool any_file = false,
                                                 std::optional<WallTime> began = std::nullopt);

  std::optional<ListedSession> find(const std::string& id) const;
  /// The live one that was begun last.
  std::optional<ListedSession> newest() const;
  std::vector<ListedSession> all() const;
  /// Whether one of them is writing this log.
  bool is_live(const std::string& log_path) const;
  void end();

  const LiveDefaults& defaults() const { return defaults_; }
  /// The name of the trace with which the next session goes on; empty: it begins anew.
  std::string next_after() const;
  const Json& setup() const { return setup_; }

 private:
  LiveSessions(LiveDefaults defaults, Json setup);
  std::variant<LiveOptions, LiveRefusal> options_of(const Json& asked, bool any_file) const;
  struct After {
    std::string name, trace;
    std::optional<bool> physics;
  };
  std::variant<std::optional<After>, LiveRefusal> after_of(const Json& asked);
  std::variant<ListedSession, LiveRefusal> begin(LiveOptions options, const std::string& name,
                                                 const std::optional<After>& after);
  void make_room();
  std::optional<std::string> take_place(LiveOptions& options, const std::string& name);

  const LiveDefaults defaults_;
  const Json setup_;
  Publish publish_;
  mutable std::mutex mutex_;  // guards the members below
  std::vector<ListedSession> sessions_;
  std::set<std::string> taken_;  // ids, some of which have yet to be begun
  std::string after_;            // LiveDefaults::after until a session has begun
};

}  // namespace continua
