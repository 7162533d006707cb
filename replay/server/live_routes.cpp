#include "continua/replay/server/live_routes.h"

#include <iterator>
#include <thread>

#include <fmt/format.h>

#include "continua/replay/live/live_tail.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/server/http_answer.h"

// After Eigen, whose names are macros of a header of the library's.
#include <httplib.h>

namespace continua {
namespace {

constexpr std::chrono::milliseconds ask_every{250};  // whether the listener is still there
constexpr int most_silent = 40;                      // such times

std::string event_text(std::string_view name, std::string_view data) {
  return fmt::format("event: {}\ndata: {}\n\n", name, data);
}

// One listener of one session.
class RecordStream {
 public:
  RecordStream(ListedSession listed, const LiveSessions& sessions, std::uint64_t from, bool is_recorder)
      : listed_(std::move(listed)), sessions_(sessions), tail_(listed_.session, from), is_recorder_(is_recorder) {
    listed_.session->audience().attend(is_recorder_, 1);
  }
  ~RecordStream() { listed_.session->audience().attend(is_recorder_, -1); }
  RecordStream(const RecordStream&) = delete;
  RecordStream& operator=(const RecordStream&) = delete;

  bool is_done() const { return done_; }

  // The next text to send; a comment if nothing happened.
  std::string next() {
    const int known = tail_.state().changes;
    const auto lines = tail_.next(ask_every);
    auto number = tail_.next_record() - lines.size();
    std::string text;
    for (const auto& line : lines)
      fmt::format_to(std::back_inserter(text), "id: {}\nevent: record\ndata: {}\n\n", number++, line);
    if (first_ || tail_.state().changes != known) text = event_text("clock", clock_text()) + text;
    first_ = false;
    if (tail_.is_done()) {
      done_ = true;
      text += event_text("ended", compact(session_json(listed_, sessions_)));
    }
    // Now and then, so that proxies on the way do not take the connection for dead.
    silent_ = text.empty() ? silent_ + 1 : 0;
    return silent_ % most_silent == most_silent - 1 ? ": nothing new\n\n" : text;
  }

 private:
  std::string clock_text() const {
    const auto& state = tail_.state();
    const auto t = std::max(state.t, state.clock.at(std::chrono::steady_clock::now()));
    return compact({{"t", t.seconds()},
                    {"running", state.clock.runs()},
                    {"speed", state.clock.speed()},
                    {"viewers", listed_.session->audience().viewers()}});
  }

  const ListedSession listed_;
  const LiveSessions& sessions_;
  LiveTail tail_;
  const bool is_recorder_;
  bool first_ = true, done_ = false;
  int silent_ = 0;  // times that there was nothing to tell
};

}  // namespace

std::shared_ptr<void> StreamSeats::take() {
  if (taken_.fetch_add(1) >= most) {
    --taken_;
    return nullptr;
  }
  return {this, [](StreamSeats* seats) { --seats->taken_; }};
}

void add_live_routes(httplib::Server& server, LiveApi& api) {
  server.Get("/api/sessions.*", [&api](const httplib::Request& request, httplib::Response& response) {
    send_answer(request, response, api.get(request.target));
  });
  server.Post("/api/sessions.*", [&api](const httplib::Request& request, httplib::Response& response) {
    send_answer(request, response, api.post(request.target, request.body));
    if (response.status == 429) response.set_header("Retry-After", "1");
  });
}

void send_records(const httplib::Request& request, httplib::Response& response, const LiveApi& api, StreamSeats& seats,
                  const std::atomic<bool>& stopping) {
  const auto id = request.get_param_value("session");
  auto listed = id.empty() ? api.sessions().newest() : api.sessions().find(id);
  if (!id.empty() && !listed)
    return send_answer(request, response, api_error(404, fmt::format("there is no session {}", in_quotes(id))));
  const auto last = id.empty() ? "" : request.get_header_value("Last-Event-ID", 0);
  const auto wanted = last.empty() ? request.get_param_value("after") : last;
  const auto after = number_in<std::uint64_t>(wanted);
  if (!after && !wanted.empty())
    return send_answer(request, response,
                       api_error(400, fmt::format("'after' is {}; expected a record's number", in_quotes(wanted))));
  const auto seat = seats.take();
  if (!seat)
    return send_answer(request, response,
                       api_error(503, fmt::format("{} runs are being followed already", StreamSeats::most)));
  const auto recorder = request.get_param_value("recorder");
  const auto from = after ? *after + 1 : 0;
  const auto open = [&api, from, recorder](ListedSession found) {
    const bool is_recorder = !recorder.empty() && recorder == found.session->setting().options.recorder;
    return std::make_shared<RecordStream>(std::move(found), api.sessions(), from, is_recorder);
  };
  auto stream = listed ? open(*std::move(listed)) : nullptr;
  response.set_header("Cache-Control", "no-store");
  response.set_chunked_content_provider(
      "text/event-stream", [&api, &stopping, open, seat, stream](std::size_t, httplib::DataSink& sink) mutable {
        if (!stream) {
          std::this_thread::sleep_for(ask_every);
          if (auto begun = api.sessions().newest()) stream = open(*std::move(begun));
        }
        const auto text = stream ? stream->next() : std::string();
        if (text.empty() ? !sink.is_writable() : !sink.write(text.data(), text.size())) return false;
        if (stream && stream->is_done()) sink.done();
        return !stopping || (stream && !stream->is_done());
      });
}

}  // namespace continua
