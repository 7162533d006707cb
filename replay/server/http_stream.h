// A whole request in memory, and the connection that its answer goes to.
#pragma once

#include <atomic>
#include <chrono>
#include <string>

#include "continua/replay/server/http_library.h"
#include "continua/replay/server/waiting_answers.h"

namespace continua {

/// With whoever reads an answer, or a piece of one without end.
struct ReaderPatience {
  static constexpr std::chrono::seconds usual{10};         ///< and longer for much:
  static constexpr std::size_t least_bytes_per_s = 65536;  ///< so that slow readers do not keep the threads that answer
  static constexpr std::chrono::seconds at_the_end{1};     ///< of the program
  static std::chrono::seconds with(std::size_t bytes) {
    return usual + std::chrono::seconds(bytes / least_bytes_per_s);
  }
};

class HttpStream : public httplib::Stream {
 public:
  /// `socket`: does not block, and outlives the stream. `waiting`: those of all connections. `stopping`: answers are
  /// cut short soon.
  HttpStream(int socket, std::string request, WaitingAnswers& waiting, const std::atomic<bool>& stopping)
      : socket_(socket), request_(std::move(request)), waiting_(waiting), stopping_(stopping) {}

  bool is_readable() const override { return read_ < request_.size(); }
  /// Whether the other side is still there. One that has not read all so far gets the patience of `write`.
  bool is_writable() const override;
  ssize_t read(char* into, size_t size) override;
  /// All of it, or -1: the other side is gone, takes less than ReaderPatience, or is one too many of those waited for.
  ssize_t write(const char* text, size_t size) override;
  void get_remote_ip_and_port(std::string& ip, int& port) const override;
  void get_local_ip_and_port(std::string& ip, int& port) const override;
  socket_t socket() const override { return socket_; }

 private:
  int socket_;
  std::string request_;
  std::size_t read_ = 0;
  WaitingAnswers& waiting_;
  const std::atomic<bool>& stopping_;
};

}  // namespace continua
