#include "continua/replay/live/live_session.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/session/live_setup.h"
#include "continua/replay/session/session_loop.h"

namespace continua {
namespace {

using namespace std::chrono_literals;

constexpr auto look_every = 8ms;                     // at a world that moves
constexpr SimTime longest_at_once{50'000};           // of engine time, while whoever sends events waits
constexpr auto sync_within = 1s;                     // of an event, to the disk
constexpr auto patience = std::chrono::minutes(10);  // with a session that nobody sends to or looks at

const Watch nobody;

std::string knowledge_folder(const std::string& asked) {
  const auto data = find_data_paths(asked);
  return data ? data->knowledge.string() : "";
}

// A server keeps every session that has ended, and most of them have the same palette.
std::shared_ptr<const Json> shared(Json palette) {
  static std::mutex mutex;
  static std::vector<std::weak_ptr<const Json>> known;  // guarded by the mutex
  const std::lock_guard lock(mutex);
  std::erase_if(known, [](const auto& one) { return one.expired(); });
  for (const auto& one : known)
    if (auto same = one.lock(); same && *same == palette) return same;
  auto made = std::make_shared<const Json>(std::move(palette));
  known.push_back(made);
  return made;
}

}  // namespace

Result<std::shared_ptr<LiveSession>> LiveSession::start(LiveOptions options, const std::vector<LiveEvent>& before) {
  options.replay.live = true;
  std::error_code ignored;
  std::vector<std::string> made{options.trace_path};
  if (!std::filesystem::exists(options.log_path, ignored)) made.push_back(options.log_path);
  const auto given_up = [&](const Error& why) {
    for (const auto& path : made) std::filesystem::remove(path, ignored);
    return why;
  };
  {
    GrowingFile trace(options.trace_path, GrowingFile::Begin::first);
    if (!trace.sound()) return trace.fault();
    if (auto unwritten = trace.add(write_header(options.header) + "\n")) return given_up(*unwritten);
  }
  auto session = Session::load(options.trace_path, options.replay);
  if (!session) return given_up(session.error());
  const std::shared_ptr<LiveSession> live(new LiveSession(options, std::move(session).value()));
  if (const auto problem = live->open(before)) return given_up(*problem);
  return live;
}

LiveSession::LiveSession(LiveOptions options, Session session)
    : setting_{options, std::filesystem::path(options.header.scene).stem().string(), session.machine().name,
               shared(gesture_palette(session.machine(), session.gestures())), session.warning()},
      media_(setting_.options.trace_path),
      session_(std::move(session)),
      recognisers_(knowledge_folder(options.replay.knowledge)),
      timing_(options.timing),
      clock_(options.speed),
      last_heard_(std::chrono::steady_clock::now()) {}

Outcome LiveSession::open(const std::vector<LiveEvent>& before) {
  trace_ = std::make_shared<GrowingFile>(setting_.options.trace_path, GrowingFile::Begin::after);
  log_ = std::make_unique<LiveLog>(setting_.options.log_path);
  if (!trace_->sound() || !log_->sound())
    return Error{trace_->sound() ? setting_.options.log_path : setting_.options.trace_path,
                 "cannot be written; expected a writable file"};
  auto loop = session_->begin(nobody, log_->stream());
  if (!loop) return loop.error();
  loop_ = std::move(*loop);
  if (!before.empty()) take(before);
  if (broke_) return *broke_;
  const auto now = std::chrono::steady_clock::now();
  if (timing_ == LiveTiming::wall) clock_.run(before.empty() ? setting_.options.began.value_or(now) : now);
  tell();
  thread_ = std::thread([this] { work(); });
  return std::nullopt;
}

LiveSession::~LiveSession() { end(); }

// The clock's time, but never less than the time that the engine has seen already.
SimTime LiveSession::now() const { return std::max(loop_->now(), clock_.at(std::chrono::steady_clock::now())); }

void LiveSession::work() {
  std::unique_lock lock(mutex_);
  while (loop_) {
    if (clock_.runs()) {
      const SimTime goal = now();
      loop_->wait_until(std::min(goal, loop_->now() + longest_at_once));
      tell();
      if (!can_go_on()) return;
      if (loop_->now() < goal) {
        // The world may take longer to work out than its time lasts: clients that send events go first.
        lock.unlock();
        while (waiting_ > 0) std::this_thread::sleep_for(50us);
        lock.lock();
        continue;
      }
    }
    const auto wall = std::chrono::steady_clock::now();
    if (unsynced_ && wall >= *unsynced_ + sync_within) {
      sync(lock);
      continue;
    }
    if (audience_.is_present()) last_heard_ = wall;
    const auto given_up = std::min(last_heard_ + patience, ends_.value_or(WallTime::max()));
    if (wall >= given_up) {
      close(now());
      return;
    }
    auto next = unsynced_ ? std::min(given_up, *unsynced_ + sync_within) : given_up;
    if (clock_.runs() && !loop_->is_at_rest()) next = std::min(next, wall + look_every);
    if (const auto due = loop_->due(); clock_.runs() && due) next = std::min(next, clock_.when(*due));
    heard_.wait_until(lock, next);
  }
}

// Nobody waits for the disk meanwhile.
void LiveSession::sync(std::unique_lock<std::mutex>& lock) {
  const auto trace = trace_;
  unsynced_.reset();
  lock.unlock();
  (void)trace->sync();
  lock.lock();
  if (loop_) (void)can_go_on();
}

std::unique_lock<std::mutex> LiveSession::lock_soon() {
  ++waiting_;
  std::unique_lock lock(mutex_);
  --waiting_;
  return lock;
}

Result<LiveReply> LiveSession::receive(const std::vector<Json>& events, const std::string& batch) {
  const auto lock = lock_soon();
  if (!batch.empty() && batch == last_batch_) return last_reply_;
  if (!loop_) return Error{"", "the session has ended"};
  const auto known = recognisers_.known_by(events);
  if (!known) return known.error();
  const bool timed_by_events = !known->empty() && has_time(known->front());
  const auto timing = timing_.value_or(timed_by_events ? LiveTiming::events : LiveTiming::wall);
  // A replay knows all events of an instant beforehand, so one that was told later has an instant of its own.
  const auto earliest = taken_ ? std::max(now(), *taken_ + SimTime{1}) : now();
  const auto timed = timed_events(*known, timing, earliest, next_line_);
  if (!timed) return timed.error();
  last_heard_ = std::chrono::steady_clock::now();
  ends_.reset();
  if (!timing_ && timing == LiveTiming::wall) clock_.run(last_heard_);
  timing_ = timing;
  take(*timed);
  if (loop_ && setting_.options.durable) {
    unsynced_.reset();
    (void)trace_->sync();
    (void)can_go_on();
  }
  if (broke_) return *broke_;
  LiveReply reply{events.size(), loop_ ? loop_->now() : audience_.state().t, log_->take_moves()};
  last_batch_ = batch;
  last_reply_ = batch.empty() ? LiveReply() : reply;
  return reply;
}

void LiveSession::take(const std::vector<LiveEvent>& events) {
  for (auto next = events.begin(); next != events.end();) {
    const SimTime t = next->t;
    if (next->event && std::holds_alternative<End>(next->event->what)) return close(t);
    const auto end = std::find_if(next, events.end(), [&](const LiveEvent& each) {
      return each.t != t || (each.event && std::holds_alternative<End>(each.event->what));
    });
    if (!take_instant({next, end})) return;
    if (t > clock_.at(std::chrono::steady_clock::now())) clock_.set(t, std::chrono::steady_clock::now());
    next = end;
  }
  if (can_go_on()) heard_.notify_all();
}

// Events of one instant. Returns whether the session goes on.
bool LiveSession::take_instant(std::span<const LiveEvent> events) {
  std::vector<TraceEvent> known;
  for (const auto& [t, event, line] : events) {
    if (!event) continue;
    // First, so that the trace has all inputs of the engine in any case.
    (void)trace_->add(line + "\n");
    if (!unsynced_) unsynced_ = std::chrono::steady_clock::now();
    ++next_line_;
    known.push_back(*event);
    if (std::holds_alternative<InputEvent>(event->what)) taken_ = t;
  }
  if (!known.empty() && !can_go_on()) return false;
  loop_->wait_until(events.front().t);
  for (const auto* event : loop_->in_order(known)) {
    loop_->wait_until(event->t);
    loop_->take(*event);
  }
  tell();
  return true;
}

// Without a place to write to the session ends.
bool LiveSession::can_go_on() {
  const bool sound = trace_->sound() && log_->sound();
  const bool too_long = sound && log_->bytes() > setting_.options.most_log_bytes;
  if (sound && !too_long) return true;
  broke_ =
      Error{trace_->sound() ? setting_.options.log_path : setting_.options.trace_path,
            too_long ? fmt::format("has {} bytes, the most of a live session; the session has ended", log_->bytes())
                     : "cannot be written any further; the session has ended"};
  close(too_long ? std::optional(now()) : std::nullopt);
  return false;
}

Outcome LiveSession::pause(bool paused) {
  const auto lock = lock_soon();
  if (!loop_) return Error{"", "the session has ended"};
  if (timing_ == LiveTiming::events) return Error{"", "its time goes by events: it stands still between them"};
  timing_ = LiveTiming::wall;
  last_heard_ = std::chrono::steady_clock::now();
  if (paused)
    clock_.stop(last_heard_);
  else
    clock_.run(last_heard_);
  loop_->wait_until(now());
  tell();
  heard_.notify_all();
  return std::nullopt;
}

void LiveSession::away(bool gone) {
  const auto lock = lock_soon();
  ends_ = gone ? std::optional(std::chrono::steady_clock::now() + setting_.options.grace) : std::nullopt;
  heard_.notify_all();
}

bool LiveSession::is_left() const {
  const std::lock_guard lock(mutex_);
  return loop_ && ends_;
}

void LiveSession::end() {
  {
    const auto lock = lock_soon();
    if (loop_) close(now());
  }
  const std::lock_guard lock(joining_);
  if (thread_.joinable()) thread_.join();
}

// `end`: when; none: nothing more can be written.
void LiveSession::close(std::optional<SimTime> end) {
  if (end) {
    (void)trace_->add(write_event({next_line_, *end, {}, End{}, {}}) + "\n");
    loop_->wait_until(*end);
  }
  summary_ = session_->end(*loop_);
  const auto wall = std::chrono::steady_clock::now();
  clock_.stop(wall);
  clock_.set(loop_->now(), wall);
  tell();
  loop_.reset();
  session_.reset();
  recognisers_.end();
  const bool kept = !trace_->close();
  log_->close();
  if (!kept && !broke_) broke_ = trace_->fault();
  if (auto problem = name_media(setting_.options.trace_path, media_.finish())) broke_ = *std::move(problem);
  tell();
  heard_.notify_all();
}

void LiveSession::tell() {
  audience_.tell([&](LiveState& told) {
    told.live = loop_ != nullptr;
    told.timing = timing_;
    told.clock = clock_;
    told.log_bytes = log_->bytes();
    told.broke = broke_;
    if (!loop_) return;
    told.t = loop_->now();
    told.machine_state = loop_->state();
  });
}

}  // namespace continua
