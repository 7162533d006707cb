// Everybody who follows live sessions, served by one thread: whatever happens in a session wakes that thread alone, it
// reads the new records once, and sends all listeners the same bytes. One that reads slowly keeps nobody waiting.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "continua/replay/live/live_sessions.h"
#include "continua/replay/server/record_pieces.h"

namespace continua {

/// What a listener asked for.
struct RecordWish {
  std::optional<ListedSession> listed;  ///< none: the one that will be begun next
  std::uint64_t from = 0;               ///< the first record that is wanted
  std::string recorder;                 ///< as who it listens (LiveOptions::recorder)
};

class RecordStreams {
 public:
  /// `stopping`: listeners of sessions that do not end are left.
  RecordStreams(std::shared_ptr<const LiveSessions> sessions, const std::atomic<bool>& stopping);
  /// Leaves all listeners.
  ~RecordStreams();
  RecordStreams(const RecordStreams&) = delete;
  RecordStreams& operator=(const RecordStreams&) = delete;

  /// Sends `head`, then the records in chunks, to a socket that does not block, until the session has ended or the
  /// listener is gone. Then calls `done`, and is done with the socket. All by one thread.
  void add(int socket, std::string head, RecordWish wish, std::function<void()> done);

  /// Waits until all listeners have been told the end, or for a second. REQUIRES `stopping`. None may be added then.
  void finish();

 private:
  using Clock = std::chrono::steady_clock;
  class Waker;
  struct Listener;

  void work();
  void take_new();
  void wait();
  bool serve(Listener& listener);
  bool send(Listener& listener);
  bool fill(Listener& listener);
  bool tell_records(Listener& listener, const LiveState& state);
  void begin(Listener& listener, ListedSession listed);
  void leave(Listener& listener);
  void look_for_room(Listener& listener, bool looks);

  const std::shared_ptr<const LiveSessions> sessions_;
  const std::atomic<bool>& stopping_;
  const std::shared_ptr<Waker> waker_;
  int poll_;
  std::map<int, std::unique_ptr<Listener>> listeners_;           // by socket
  std::map<std::string, std::unique_ptr<RecordPieces>> pieces_;  // by session, of those that are listened to
  bool busy_ = false;                                            // somebody takes more at once
  std::atomic<bool> finishing_ = false;

  std::mutex mutex_;  // guards the next
  std::vector<std::unique_ptr<Listener>> new_;
  std::thread thread_;  // last: uses all of the above
};

}  // namespace continua
