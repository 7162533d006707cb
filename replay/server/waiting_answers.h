// The answers that wait for their readers, each on one of the threads that answer: a bound on how many do.
#pragma once

#include <list>
#include <mutex>

namespace continua {

/// Safe to use from several threads.
class WaitingAnswers {
 public:
  static constexpr int most = 16;

  /// The answer on this socket waits as long as this lives. Beyond `most`, the connection that has waited longest is
  /// shut down, which wakes whoever waits on it. REQUIRES that the socket is closed later.
  class Place {
   public:
    Place(WaitingAnswers& all, int socket);
    ~Place();
    Place(const Place&) = delete;
    Place& operator=(const Place&) = delete;

   private:
    WaitingAnswers& all_;
    int socket_;
  };

 private:
  std::mutex mutex_;
  std::list<int> waiting_;  // sockets, the longest first
};

}  // namespace continua
