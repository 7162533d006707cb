#include "continua/replay/server/http_door.h"

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

#include "continua/core/result.h"
#include "continua/replay/server/http_stream.h"

namespace continua {
namespace {

using namespace std::chrono_literals;

constexpr std::size_t most_at_once = 65536;                  // bytes of one connection, before others have their turn
constexpr std::size_t most_ignored = std::size_t{16} << 20;  // bytes behind a refusal, so that its answer gets through
constexpr auto ignored_for = 2s;
constexpr auto without_sockets = 100ms;  // the time after which the kernel may have some again

}  // namespace

struct HttpDoor::Connection {
  enum class Stage { reading, answering, refused, closed };

  ~Connection() { ::close(socket); }

  int socket = -1;
  Stage stage = Stage::reading;
  std::string in;  // that was not taken yet
  HeadScan scan;
  std::optional<HttpHead> head;  // of the request whose body comes
  Clock::time_point begun, deadline;
  std::size_t ignored = 0;
};

// The threads that answer.
class HttpDoor::Pool : public httplib::ThreadPool {
  using ThreadPool::ThreadPool;
};

HttpDoor::HttpDoor(Rules rules)
    : rules_(std::move(rules)),
      waker_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)),
      poll_(::epoll_create1(EPOLL_CLOEXEC)) {
  require(waker_ >= 0 && poll_ >= 0, "the kernel gives no eventfd, or no epoll");
  look_at(waker_, true);
}

HttpDoor::~HttpDoor() {
  ::close(poll_);
  ::close(waker_);
}

void HttpDoor::wake() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = ::write(waker_, &one, sizeof one);
}

void HttpDoor::stop() {
  stopping_ = true;
  wake();
}

void HttpDoor::run(int listening) {
  pool_ = std::make_unique<Pool>(static_cast<std::size_t>(rules_.threads));
  while (!stopping_) {
    take_back();
    wait(listening);
    for (auto& [socket, connection] : connections_) look_at_time(*connection);
    std::erase_if(connections_, [](const auto& one) { return one.second->stage == Connection::Stage::closed; });
  }
  std::erase_if(connections_, [](const auto& one) { return one.second->stage != Connection::Stage::answering; });
  pool_->shutdown();
  rules_.finish();
  connections_.clear();
}

void HttpDoor::wait(int listening) {
  const auto now = Clock::now();
  auto next = now + DoorLimits::whole;
  const bool accepts = now >= accept_again_;
  if (accepts != accepting_) look_at(listening, accepts);
  accepting_ = accepts;
  if (!accepts) next = accept_again_;
  for (const auto& [socket, connection] : connections_)
    if (connection->stage != Connection::Stage::answering) next = std::min(next, connection->deadline);
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(next - now).count();
  std::array<epoll_event, 64> happened;
  const int count = ::epoll_wait(poll_, happened.data(), static_cast<int>(happened.size()),
                                 static_cast<int>(std::max<std::int64_t>(left, 0)));
  bool somebody_comes = false;
  for (int i = 0; i < count; ++i) {
    const int file = happened[static_cast<std::size_t>(i)].data.fd;
    if (file == waker_) {
      std::uint64_t times = 0;
      [[maybe_unused]] const auto got = ::read(waker_, &times, sizeof times);
    } else if (file == listening) {
      somebody_comes = true;
    } else {
      read(*connections_.at(file));
    }
  }
  // Last, since a socket that was closed may come again under its number.
  std::erase_if(connections_, [](const auto& one) { return one.second->stage == Connection::Stage::closed; });
  if (somebody_comes) accept_all(listening);
}

void HttpDoor::look_at(int file, bool looks) const {
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = file;
  ::epoll_ctl(poll_, looks ? EPOLL_CTL_ADD : EPOLL_CTL_DEL, file, &event);
}

void HttpDoor::accept_all(int listening) {
  for (int i = 0; i < DoorLimits::backlog; ++i) {
    const int socket = ::accept4(listening, nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC);
    if (socket < 0) {
      if (errno == ECONNABORTED || errno == EINTR) continue;
      if (errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM) {
        make_room();
        accept_again_ = Clock::now() + without_sockets;
      }
      return;
    }
    ::setsockopt(socket, SOL_SOCKET, SO_SNDBUF, &DoorLimits::unread, sizeof DoorLimits::unread);
    auto connection = std::make_unique<Connection>();
    connection->socket = socket;
    connection->begun = Clock::now();
    connection->deadline = connection->begun + DoorLimits::idle;
    if (connections_.size() >= DoorLimits::connections) make_room();
    connections_.emplace(socket, std::move(connection));
    look_at(socket, true);
  }
}

void HttpDoor::make_room() {
  auto oldest = connections_.end();
  for (auto one = connections_.begin(); one != connections_.end(); ++one)
    if (one->second->stage != Connection::Stage::answering &&
        (oldest == connections_.end() || one->second->begun < oldest->second->begun))
      oldest = one;
  if (oldest == connections_.end()) return;
  hang_up(*oldest->second);
  connections_.erase(oldest);
}

void HttpDoor::read(Connection& connection) {
  std::array<char, 16384> part;
  for (std::size_t read = 0; read < most_at_once; read += part.size()) {
    const auto got = ::recv(connection.socket, part.data(), part.size(), 0);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) break;
    if (got <= 0) return hang_up(connection);
    const auto size = static_cast<std::size_t>(got);
    if (connection.stage == Connection::Stage::refused) {
      connection.ignored += size;
      if (connection.ignored > most_ignored) return hang_up(connection);
      continue;
    }
    if (connection.in.empty() && !connection.head) {
      connection.begun = Clock::now();
      connection.deadline = connection.begun + DoorLimits::head;
    }
    connection.in.append(part.data(), size);
    advance(connection);
    if (connection.stage == Connection::Stage::answering || connection.stage == Connection::Stage::closed) return;
  }
}

void HttpDoor::advance(Connection& connection) {
  if (!connection.head && !take_head(connection)) return;
  if (connection.in.size() >= connection.head->body) hand_on(connection);
}

// False: there is none yet, or it was refused.
bool HttpDoor::take_head(Connection& connection) {
  auto found = connection.scan.look(connection.in);
  if (const auto* refused = std::get_if<HttpAnswer>(&found)) return refuse(connection, *refused), false;
  const auto end = std::get<std::optional<std::size_t>>(found);
  if (!end) return false;
  auto read = read_head(std::string_view(connection.in).substr(0, *end));
  if (const auto* refused = std::get_if<HttpAnswer>(&read)) return refuse(connection, *refused), false;
  auto& head = std::get<HttpHead>(read);
  if (const auto refused = rules_.check(head)) return refuse(connection, *refused), false;
  if (bodies_ + head.body > DoorLimits::bodies)
    return refuse(connection, {503, "too much is being sent at the moment", {{"Retry-After", "1"}}}), false;
  bodies_ += head.body;
  connection.in.erase(0, *end);
  connection.scan = {};
  connection.deadline = connection.begun + DoorLimits::whole;
  if (head.header("Expect") && connection.in.size() < head.body) {
    constexpr std::string_view go_on = "HTTP/1.1 100 Continue\r\n\r\n";
    ::send(connection.socket, go_on.data(), go_on.size(), MSG_NOSIGNAL);
  }
  connection.head = std::move(head);
  return true;
}

void HttpDoor::hand_on(Connection& connection) {
  auto request = connection.head->text() + connection.in.substr(0, connection.head->body);
  connection.in.erase(0, connection.head->body);
  connection.stage = Connection::Stage::answering;
  look_at(connection.socket, false);
  if (rules_.follow(*connection.head, connection.socket,
                    [this, socket = connection.socket] { give_back(socket, false); }))
    return;
  pool_->enqueue([this, socket = connection.socket, last = !connection.head->keeps_alive, text = std::move(request)] {
    HttpStream stream(socket, text, waiting_, stopping_);
    give_back(socket, rules_.answer(stream, last) && !last);
  });
}

void HttpDoor::give_back(int socket, bool kept) {
  {
    const std::lock_guard lock(mutex_);
    answered_.emplace_back(socket, kept);
  }
  wake();
}

void HttpDoor::take_back() {
  std::vector<std::pair<int, bool>> answered;
  {
    const std::lock_guard lock(mutex_);
    answered.swap(answered_);
  }
  for (const auto& [socket, kept] : answered) {
    auto& connection = *connections_.at(socket);
    bodies_ -= std::exchange(connection.head, std::nullopt)->body;
    connection.begun = Clock::now();
    look_at(socket, true);
    if (!kept) {
      ::shutdown(socket, SHUT_WR);
      connection.stage = Connection::Stage::refused;
      connection.deadline = connection.begun + ignored_for;
      continue;
    }
    connection.stage = Connection::Stage::reading;
    connection.deadline = connection.begun + (connection.in.empty() ? DoorLimits::idle : DoorLimits::head);
    if (!connection.in.empty()) advance(connection);
  }
}

// Hangs up when the other side has, or soon: bytes that nobody reads would make the kernel take the answer back.
void HttpDoor::refuse(Connection& connection, const HttpAnswer& answer) {
  const auto text = rules_.written(answer);
  ::send(connection.socket, text.data(), text.size(), MSG_NOSIGNAL);
  ::shutdown(connection.socket, SHUT_WR);
  connection.in = {};
  connection.stage = Connection::Stage::refused;
  connection.deadline = Clock::now() + ignored_for;
}

void HttpDoor::hang_up(Connection& connection) {
  if (connection.head) bodies_ -= std::exchange(connection.head, std::nullopt)->body;
  connection.stage = Connection::Stage::closed;
}

void HttpDoor::look_at_time(Connection& connection) {
  const bool waits = connection.stage == Connection::Stage::reading || connection.stage == Connection::Stage::refused;
  if (!waits || Clock::now() < connection.deadline) return;
  const bool unfinished = connection.head || !connection.in.empty();
  if (connection.stage == Connection::Stage::refused || !unfinished) return hang_up(connection);
  if (connection.head) bodies_ -= std::exchange(connection.head, std::nullopt)->body;
  refuse(connection, {408, "the request did not come to its end in time", {}});
}

}  // namespace continua
