#include "continua/replay/server/record_streams.h"

#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

#include "continua/replay/live/live_api.h"
#include "continua/replay/server/http_stream.h"

namespace continua {
namespace {

using namespace std::chrono_literals;

constexpr auto look_again = 250ms;  // for a session that begins, and at listeners that take nothing
constexpr auto silence = 10s;       // after which a listener is told that nothing happens: proxies on the way hang up

std::string clock_text(const ListedSession& listed, const LiveState& state) {
  const auto t = std::max(state.t, state.clock.at(std::chrono::steady_clock::now()));
  return compact({{"t", t.seconds()},
                  {"running", state.clock.runs()},
                  {"speed", state.clock.speed()},
                  {"viewers", listed.session->audience().viewers()}});
}

}  // namespace

// Sessions keep it as long as they like.
class RecordStreams::Waker {
 public:
  Waker() : file_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) { require(file_ >= 0, "the kernel gives no eventfd"); }
  ~Waker() { ::close(file_); }
  Waker(const Waker&) = delete;
  Waker& operator=(const Waker&) = delete;

  int file() const { return file_; }
  void wake() const {
    const std::uint64_t one = 1;
    [[maybe_unused]] const auto written = ::write(file_, &one, sizeof one);
  }
  void rest() const {
    std::uint64_t times = 0;
    [[maybe_unused]] const auto got = ::read(file_, &times, sizeof times);
  }

 private:
  int file_;
};

struct RecordStreams::Listener {
  int socket = -1;
  RecordWish wish;
  std::function<void()> done;

  LogPlace place;              // that it has been told up to
  std::optional<int> changes;  // LiveState::changes that it has been told of
  bool has_more = false, told_end = false, gone = false, waits_for_room = false;
  std::deque<std::shared_ptr<const std::string>> queue;
  std::size_t sent = 0;             // of the first in the queue
  Clock::time_point began, active;  // when the first in the queue was its turn; when it last was told something

  void say(std::string text) { queue.push_back(std::make_shared<const std::string>(std::move(text))); }
};

RecordStreams::RecordStreams(std::shared_ptr<const LiveSessions> sessions, const std::atomic<bool>& stopping)
    : sessions_(std::move(sessions)),
      stopping_(stopping),
      waker_(std::make_shared<Waker>()),
      poll_(::epoll_create1(EPOLL_CLOEXEC)) {
  require(poll_ >= 0, "the kernel gives no epoll");
  epoll_event event{};
  event.events = EPOLLIN;
  event.data.fd = waker_->file();
  ::epoll_ctl(poll_, EPOLL_CTL_ADD, waker_->file(), &event);
}

RecordStreams::~RecordStreams() {
  finish();
  ::close(poll_);
}

void RecordStreams::finish() {
  finishing_ = true;
  waker_->wake();
  if (thread_.joinable()) thread_.join();
}

void RecordStreams::add(int socket, std::string head, RecordWish wish, std::function<void()> done) {
  auto listener = std::make_unique<Listener>();
  listener->socket = socket;
  listener->wish = std::move(wish);
  listener->done = std::move(done);
  listener->began = listener->active = Clock::now();
  listener->say(std::move(head));
  {
    const std::lock_guard lock(mutex_);
    new_.push_back(std::move(listener));
  }
  waker_->wake();
  // Not before: a thread that was begun earlier would get the signals that the program waits for.
  if (!thread_.joinable()) thread_ = std::thread([this] { work(); });
}

void RecordStreams::work() {
  std::optional<Clock::time_point> last;
  for (;;) {
    take_new();
    for (auto& [socket, listener] : listeners_)
      if (!serve(*listener)) leave(*listener);
    std::erase_if(listeners_, [](const auto& one) { return one.second->gone; });
    std::erase_if(pieces_, [&](const auto& one) {
      return std::none_of(listeners_.begin(), listeners_.end(), [&](const auto& listener) {
        return listener.second->wish.listed && listener.second->wish.listed->id == one.first;
      });
    });
    if (finishing_) {
      if (!last) last = Clock::now() + ReaderPatience::at_the_end;
      if (listeners_.empty() || Clock::now() > *last) break;
    }
    wait();
  }
  for (auto& [socket, listener] : listeners_) leave(*listener);
  listeners_.clear();
}

void RecordStreams::take_new() {
  std::vector<std::unique_ptr<Listener>> found;
  {
    const std::lock_guard lock(mutex_);
    found.swap(new_);
  }
  for (auto& listener : found) {
    epoll_event event{};
    event.events = EPOLLRDHUP;
    event.data.fd = listener->socket;
    ::epoll_ctl(poll_, EPOLL_CTL_ADD, listener->socket, &event);
    if (listener->wish.listed) begin(*listener, *listener->wish.listed);
    listeners_.emplace(listener->socket, std::move(listener));
  }
}

// Until something happened, or it is time to look.
void RecordStreams::wait() {
  std::array<epoll_event, 64> happened;
  const int longest = std::exchange(busy_, false)         ? 0
                      : listeners_.empty() && !finishing_ ? -1
                                                          : static_cast<int>(look_again.count());
  const int count = ::epoll_wait(poll_, happened.data(), static_cast<int>(happened.size()), longest);
  for (int i = 0; i < count; ++i) {
    const auto& event = happened[static_cast<std::size_t>(i)];
    if (event.data.fd == waker_->file())
      waker_->rest();
    else if (auto& listener = *listeners_.at(event.data.fd); (event.events & (EPOLLRDHUP | EPOLLHUP | EPOLLERR)) != 0)
      leave(listener);
    else
      look_for_room(listener, false);
  }
  std::erase_if(listeners_, [](const auto& one) { return one.second->gone; });
}

void RecordStreams::begin(Listener& listener, ListedSession listed) {
  const auto& own = listed.session->setting().options.recorder;
  auto& audience = listed.session->audience();
  audience.wake_by([waker = waker_] { waker->wake(); });
  audience.attend(!own.empty() && listener.wish.recorder == own, 1);
  auto& pieces = pieces_[listed.id];
  if (!pieces) pieces = std::make_unique<RecordPieces>(listed.session->setting().options.log_path);
  listener.wish.listed = std::move(listed);
}

void RecordStreams::leave(Listener& listener) {
  if (std::exchange(listener.gone, true)) return;
  ::epoll_ctl(poll_, EPOLL_CTL_DEL, listener.socket, nullptr);
  if (const auto& listed = listener.wish.listed) {
    const auto& own = listed->session->setting().options.recorder;
    listed->session->audience().attend(!own.empty() && listener.wish.recorder == own, -1);
  }
  listener.done();
}

void RecordStreams::look_for_room(Listener& listener, bool looks) {
  if (std::exchange(listener.waits_for_room, looks) == looks) return;
  epoll_event event{};
  event.events = EPOLLRDHUP;
  if (looks) event.events |= EPOLLOUT;
  event.data.fd = listener.socket;
  ::epoll_ctl(poll_, EPOLL_CTL_MOD, listener.socket, &event);
}

// False: there is nothing more to do for it.
bool RecordStreams::serve(Listener& listener) {
  if (!send(listener)) return false;
  if (!listener.queue.empty()) return true;
  if (listener.told_end) return false;
  if (!fill(listener) || !send(listener)) return false;
  if (listener.queue.empty() && listener.has_more) busy_ = true;
  return !(listener.told_end && listener.queue.empty());
}

// As much of the queue as there is room for. False: the listener is gone, or takes too little.
bool RecordStreams::send(Listener& listener) {
  if (listener.waits_for_room)
    return Clock::now() < listener.began + ReaderPatience::with(listener.queue.front()->size());
  while (!listener.queue.empty()) {
    const auto& text = *listener.queue.front();
    const auto part =
        ::send(listener.socket, text.data() + listener.sent, text.size() - listener.sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (part < 0 && errno == EINTR) continue;
    if (part < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
      look_for_room(listener, true);
      return true;
    }
    if (part <= 0) return false;
    listener.sent += static_cast<std::size_t>(part);
    if (listener.sent < text.size()) continue;
    listener.queue.pop_front();
    listener.sent = 0;
    listener.began = Clock::now();
  }
  return true;
}

// The next to tell, if anything. False: there will never be anything.
bool RecordStreams::fill(Listener& listener) {
  if (!listener.wish.listed) {
    if (stopping_) return false;
    auto begun = sessions_->newest();
    if (!begun) return true;
    begin(listener, *std::move(begun));
  }
  const auto& listed = *listener.wish.listed;
  const auto state = listed.session->audience().state();
  if (listener.changes != state.changes) listener.say(chunk_of(event_text("clock", clock_text(listed, state))));
  listener.changes = state.changes;
  listener.has_more = tell_records(listener, state);
  if (!state.live && !listener.has_more) {
    listener.say(chunk_of(event_text("ended", compact(session_json(listed, *sessions_)))) + "0\r\n\r\n");
    listener.told_end = true;
  }
  const auto now = Clock::now();
  if (listener.queue.empty() && now - listener.active > silence) listener.say(chunk_of(": nothing new\n\n"));
  if (!listener.queue.empty()) listener.began = listener.active = now;
  return true;
}

// Whether there are more in the log. One that was cut has no more, whatever was announced.
bool RecordStreams::tell_records(Listener& listener, const LiveState& state) {
  if (listener.place.bytes >= state.log_bytes) return false;
  const auto piece = pieces_.at(listener.wish.listed->id)->at(listener.place, state.log_bytes, listener.wish.from);
  if (!piece) return false;
  listener.place = piece->end;
  if (piece->chunk) listener.queue.push_back(piece->chunk);
  return listener.place.bytes < state.log_bytes;
}

}  // namespace continua
