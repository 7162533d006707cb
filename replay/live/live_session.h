// A session that happens now: events come in as they happen, and a trace and a run log are written along. A live
// session replays to the same decisions, since the trace says when the engine learned of each event.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "continua/replay/live/live_audience.h"
#include "continua/replay/live/live_clock.h"
#include "continua/replay/live/live_events.h"
#include "continua/replay/live/live_log.h"
#include "continua/replay/live/live_media.h"
#include "continua/replay/live/live_recognisers.h"
#include "continua/replay/session/session.h"

namespace continua {

struct LiveOptions {
  std::string trace_path, log_path;  ///< written anew
  TraceHeader header;                ///< scene and machine are needed
  ReplayOptions replay;
  std::optional<LiveTiming> timing;                       ///< none: by events, if the first of them tells its time
  std::optional<WallTime> began;                          ///< its time 0 by the wall's clock; none: when it is loaded
  double speed = 1;                                       ///< of the wall's clock
  std::uint64_t most_log_bytes = std::uint64_t{1} << 30;  ///< a day of talk with physics has less
  std::chrono::milliseconds grace{30'000};                ///< for a recorder who has gone away to come back
  bool durable = false;                                   ///< each acknowledged event is on the disk (see receive)
  std::string recorder;                                   ///< whoever sends events has to name it; empty: nobody has to
};

/// The parts of a session that stay the same.
struct LiveSetting {
  LiveOptions options;
  std::string scene, machine;  ///< the names by which the log has them
  /// The gestures that a human may make (live_setup.h, gesture_palette); one for all sessions that have the same ones.
  std::shared_ptr<const Json> palette;
  std::optional<Error> warning;  ///< the unknown things of the scene; it can be used all the same
};

/// The answer to events that were taken.
struct LiveReply {
  std::size_t accepted = 0;
  SimTime t;                       ///< the engine's time
  std::vector<std::string> moves;  ///< the avatar's deeds since the last reply: records of the log
};

/// Safe to use from several threads. Time goes on by a thread of its own.
class LiveSession {
 public:
  /// `before`: events of an ended session that this one goes on with; its time begins where they end. Errors: of the
  /// loaded parts; a file that cannot be written.
  static Result<std::shared_ptr<LiveSession>> start(LiveOptions options, const std::vector<LiveEvent>& before = {});
  /// Ends it.
  ~LiveSession();
  LiveSession(const LiveSession&) = delete;
  LiveSession& operator=(const LiveSession&) = delete;

  /// Takes all of the events or, if one cannot be used, none; outputs of recognisers among them as the events that are
  /// known by them (live_recognisers.h). Errors: the reason, or that the session has ended.
  /// `batch` names the events, or is empty: events that come again under the name of the last batch, since its answer
  /// was lost, are answered again and not taken again.
  ///
  /// Events that were taken are in the trace, whole, before the answer: the end of the program, however it ends, loses
  /// none. The end of the machine loses those of the last second; none with the option `durable`.
  Result<LiveReply> receive(const std::vector<Json>& events, const std::string& batch = "");

  /// Engine time stands still, or goes on. Error: the session has ended, or its time goes by events.
  Outcome pause(bool paused);

  /// Whoever records has gone away, or is back: unless it sends something or is told to be back, the session ends after
  /// `grace`. After the end it does nothing.
  void away(bool gone);
  /// Whether it only waits for whoever records to come back.
  bool is_left() const;

  /// Nothing more happens: acts under way are finished, trace and log get their last lines. Ending again does nothing.
  void end();

  const LiveSetting& setting() const { return setting_; }
  /// After the end.
  const ReplaySummary& summary() const { return summary_; }
  /// Recordings of the human. At the end the trace's header names them.
  LiveMedia& media() const { return media_; }
  /// Its state, for viewers, and their number.
  LiveAudience& audience() const { return audience_; }

 private:
  LiveSession(LiveOptions options, Session session);
  Outcome open(const std::vector<LiveEvent>& before);
  std::unique_lock<std::mutex> lock_soon();
  void work();
  SimTime now() const;
  void sync(std::unique_lock<std::mutex>& lock);
  void take(const std::vector<LiveEvent>& events);
  bool take_instant(std::span<const LiveEvent> events);
  bool can_go_on();
  void close(std::optional<SimTime> end);
  void tell();

  const LiveSetting setting_;
  mutable LiveAudience audience_;
  mutable LiveMedia media_;

  std::atomic<int> waiting_ = 0;  // for the next
  mutable std::mutex mutex_;      // guards the members below
  std::condition_variable heard_;
  std::optional<Session> session_;
  std::shared_ptr<GrowingFile> trace_;  // shared with a sync that is under way
  std::optional<WallTime> unsynced_;    // since when the trace has something that may not be on the disk
  std::unique_ptr<LiveLog> log_;
  std::unique_ptr<SessionLoop> loop_;  // none: it has ended, and so have the three above
  LiveRecognisers recognisers_;
  std::optional<LiveTiming> timing_;
  LiveClock clock_;
  std::size_t next_line_ = 2;
  std::optional<SimTime> taken_;  // the instant of the latest event
  WallTime last_heard_;
  std::optional<WallTime> ends_;  // unless whoever records comes back
  std::string last_batch_;
  LiveReply last_reply_;
  std::optional<Error> broke_;
  ReplaySummary summary_;

  std::mutex joining_;
  std::thread thread_;
};

}  // namespace continua
