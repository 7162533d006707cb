// A session that happens now: events come in as they happen, and a trace and a run log are written along. A live
// session replays to the same decisions, since the trace says when the engine learned of each event.
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "continua/replay/live/live_clock.h"
#include "continua/replay/live/live_events.h"
#include "continua/replay/live/live_log.h"
#include "continua/replay/session/session.h"

namespace continua {

struct LiveOptions {
  std::string trace_path, log_path;  ///< written anew
  TraceHeader header;                ///< scene and machine are needed
  ReplayOptions replay;
  std::optional<LiveTiming> timing;  ///< none: by events, if the first of them tells its time
  double speed = 1;                  ///< of the wall's clock
  std::string recorder;              ///< whoever sends events has to name it; empty: nobody has to
};

/// The state of a session at a moment.
struct LiveState {
  bool live = true;
  std::optional<LiveTiming> timing;
  LiveClock clock;
  SimTime t;                  ///< as far as the engine has come
  std::string machine_state;  ///< the state of the machine
  std::uint64_t log_bytes = 0;
  int changes = 0;             ///< counts changes that a viewer is told of besides the log: pauses, viewers, the end
  std::optional<Error> broke;  ///< why it ended, if not because it was told to
};

/// Safe to use from several threads. Time goes on by a thread of its own.
class LiveSession {
 public:
  /// Errors: of the loaded parts; a file that cannot be written.
  static Result<std::shared_ptr<LiveSession>> start(LiveOptions options);
  /// Ends it.
  ~LiveSession();
  LiveSession(const LiveSession&) = delete;
  LiveSession& operator=(const LiveSession&) = delete;

  struct Reply {
    std::size_t accepted = 0;
    SimTime t;                       ///< the engine's time
    std::vector<std::string> moves;  ///< the avatar's deeds since the last reply: records of the log
  };
  /// Takes all of the events or, if one cannot be used, none. Errors: the reason, or that the session has ended.
  /// `batch` names the events, or is empty: events that come again under the name of the last batch, since its answer
  /// was lost, are answered again and not taken again.
  Result<Reply> receive(const std::vector<Json>& events, const std::string& batch = "");

  /// Engine time stands still, or goes on. Error: the session has ended, or its time goes by events.
  Outcome pause(bool paused);

  /// Nothing more happens: acts under way are finished, trace and log get their last lines. Ending again does nothing.
  void end();

  LiveState state() const;
  /// The unknown things of the scene; it can be used all the same.
  const std::optional<Error>& warning() const { return warning_; }
  /// After the end.
  const ReplaySummary& summary() const { return summary_; }
  const LiveOptions& options() const { return options_; }
  /// The names by which the log has them.
  const std::string& scene() const { return scene_; }
  const std::string& machine() const { return machine_; }
  /// The gestures that a human may make (live_setup.h, gesture_palette).
  const Json& palette() const { return palette_; }

  /// Waits until there is more to tell than in `known`, at most so long.
  LiveState wait(const LiveState& known, std::chrono::milliseconds patience) const;
  /// Whoever records it, or somebody else, listens from now on (`more` 1) or has gone (-1).
  void attend(bool is_recorder, int more);
  /// The listeners, without the one that records the session.
  int viewers() const;

 private:
  LiveSession(LiveOptions options, Session session);
  Outcome open();
  std::unique_lock<std::mutex> lock_soon();
  void work();
  SimTime now() const;
  bool is_attended() const;
  void take(const std::vector<LiveEvent>& events);
  bool can_go_on();
  void close(std::optional<SimTime> end);
  void tell();

  const LiveOptions options_;
  const std::string scene_, machine_;
  const Json palette_;
  const std::optional<Error> warning_;

  std::atomic<int> waiting_ = 0;  // for the next
  mutable std::mutex mutex_;      // guards the members below
  std::condition_variable heard_;
  std::optional<Session> session_;
  std::ofstream trace_;
  std::unique_ptr<LiveLog> log_;
  std::unique_ptr<SessionLoop> loop_;  // none: it has ended, and so have the three above
  std::optional<LiveTiming> timing_;
  LiveClock clock_;
  std::size_t next_line_ = 2;
  WallTime last_heard_;
  std::string last_batch_;
  Reply last_reply_;
  std::optional<Error> broke_;
  ReplaySummary summary_;

  mutable std::mutex told_mutex_;  // guards the members below; needs no wait for the engine
  mutable std::condition_variable told_changed_;
  LiveState told_;
  int viewers_ = 0, recorders_ = 0;  // that listen

  std::mutex joining_;
  std::thread thread_;
};

}  // namespace continua
