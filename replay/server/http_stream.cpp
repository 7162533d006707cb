#include "continua/replay/server/http_stream.h"

#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <optional>

namespace continua {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int look_every_ms = 100;  // whether the program ends

bool can_be_written(int socket, int wait_ms) {
  pollfd waiting{socket, POLLOUT, 0};
  return ::poll(&waiting, 1, wait_ms) > 0 && (waiting.revents & POLLOUT) != 0;
}

void read_name(int socket, int (*asked)(int, sockaddr*, socklen_t*), std::string& ip, int& port) {
  sockaddr_storage address{};
  socklen_t size = sizeof address;
  char host[NI_MAXHOST], service[NI_MAXSERV];
  if (asked(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0 ||
      ::getnameinfo(reinterpret_cast<sockaddr*>(&address), size, host, sizeof host, service, sizeof service,
                    NI_NUMERICHOST | NI_NUMERICSERV) != 0)
    return;
  ip = host;
  port = std::atoi(service);
}

}  // namespace

bool HttpStream::is_writable() const {
  char byte;
  const auto got = ::recv(socket_, &byte, 1, MSG_PEEK | MSG_DONTWAIT);
  return got > 0 || (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR));
}

ssize_t HttpStream::read(char* into, size_t size) {
  const auto part = std::min(size, request_.size() - read_);
  std::memcpy(into, request_.data() + read_, part);
  read_ += part;
  return static_cast<ssize_t>(part);
}

ssize_t HttpStream::write(const char* text, size_t size) {
  const auto begun = Clock::now();
  const auto most = ReaderPatience::with(size);
  std::optional<WaitingAnswers::Place> waits;
  for (std::size_t sent = 0; sent < size;) {
    const auto part = ::send(socket_, text + sent, size - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (part > 0) {
      sent += static_cast<std::size_t>(part);
      waits.reset();
      continue;
    }
    if (part == 0 || (errno != EAGAIN && errno != EWOULDBLOCK && errno != EINTR)) return -1;
    if (Clock::now() - begun > (stopping_ ? ReaderPatience::at_the_end : most)) return -1;
    if (!waits) waits.emplace(waiting_, socket_);
    can_be_written(socket_, look_every_ms);
  }
  return static_cast<ssize_t>(size);
}

void HttpStream::get_remote_ip_and_port(std::string& ip, int& port) const {
  read_name(socket_, ::getpeername, ip, port);
}

void HttpStream::get_local_ip_and_port(std::string& ip, int& port) const {
  read_name(socket_, ::getsockname, ip, port);
}

}  // namespace continua
