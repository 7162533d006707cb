// Where requests come in: one thread reads those of all connections, within limits of size and time, and hands each on
// once it is whole. A slow connection takes a few bytes of memory and nobody's time.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "continua/replay/server/http_head.h"
#include "continua/replay/server/waiting_answers.h"

namespace continua {

class HttpStream;

/// The most that connections may take. Above `connections` the one that has kept the server waiting longest is closed.
struct DoorLimits {
  static constexpr std::size_t connections = 512;
  static constexpr std::size_t bodies = std::size_t{64} << 20;  ///< bytes, of all requests at a time
  static constexpr int backlog = 512;                           ///< connections that the kernel keeps
  static constexpr int unread = 256 << 10;          ///< bytes of an answer that it keeps; it takes twice that
  static constexpr std::chrono::seconds idle{10};   ///< until a next request begins
  static constexpr std::chrono::seconds head{10};   ///< from a request's first byte to the end of its head
  static constexpr std::chrono::seconds whole{30};  ///< likewise, to the end of its body
};

class HttpDoor {
 public:
  struct Rules {
    /// An answer that the head alone earns: the body is not read and the connection ends.
    std::function<std::optional<HttpAnswer>(const HttpHead&)> check;
    /// As bytes, with Connection: close.
    std::function<std::string(const HttpAnswer&)> written;
    /// Answers a whole request, on one of `threads` threads. `last`: no other follows on its connection. False: the
    /// answer could not be written.
    std::function<bool(HttpStream&, bool last)> answer;
    int threads = 1;
    /// Takes the connection of a request for an answer without end, and calls `done` when nothing more is sent on it,
    /// from any thread. False: it is a request like others.
    std::function<bool(const HttpHead&, int socket, std::function<void()> done)> follow;
    /// Waits until all that `follow` took is done. The door stops.
    std::function<void()> finish;
  };

  explicit HttpDoor(Rules rules);
  ~HttpDoor();
  HttpDoor(const HttpDoor&) = delete;
  HttpDoor& operator=(const HttpDoor&) = delete;

  /// Until stop(). `listening`: a bound socket that listens.
  void run(int listening);
  /// May be called from any thread, also before run().
  void stop();

 private:
  using Clock = std::chrono::steady_clock;
  struct Connection;
  class Pool;

  void accept_all(int listening);
  void make_room();
  void take_back();
  void wait(int listening);
  void look_at(int file, bool looks) const;
  void read(Connection& connection);
  void advance(Connection& connection);
  bool take_head(Connection& connection);
  void hand_on(Connection& connection);
  void refuse(Connection& connection, const HttpAnswer& answer);
  void give_back(int socket, bool kept);
  void hang_up(Connection& connection);
  void look_at_time(Connection& connection);
  void wake();

  const Rules rules_;
  int waker_, poll_;
  bool accepting_ = false;  // whether the listening socket is looked at
  std::atomic<bool> stopping_ = false;
  std::map<int, std::unique_ptr<Connection>> connections_;  // by socket
  std::size_t bodies_ = 0;                                  // bytes that are read or answered
  Clock::time_point accept_again_;

  WaitingAnswers waiting_;
  std::mutex mutex_;                            // guards the next
  std::vector<std::pair<int, bool>> answered_;  // sockets, and whether they are to be kept
  std::unique_ptr<Pool> pool_;
};

}  // namespace continua
