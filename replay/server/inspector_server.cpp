#include "continua/replay/server/inspector_server.h"

#include <fcntl.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "continua/core/gzip.h"
#include "continua/replay/experiment/what_if_session.h"
#include "continua/replay/inspector/inspector_api.h"
#include "continua/replay/live/hand_model.h"
#include "continua/replay/pictures/frame_cache.h"
#include "continua/replay/server/access.h"
#include "continua/replay/server/http_answer.h"
#include "continua/replay/server/http_door.h"
#include "continua/replay/server/http_library.h"
#include "continua/replay/server/http_stream.h"
#include "continua/replay/server/live_routes.h"
#include "continua/replay/server/media_answer.h"
#include "continua/web/assets.h"

namespace continua {
namespace {

constexpr int other_threads = 16;
constexpr int ports_tried = 50;
constexpr std::chrono::milliseconds look_every{200};  // at a run that is being written

// Only this server's own answers may be loaded, run, framed or sent to.
constexpr auto policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; media-src 'self'; connect-src "
    "'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

// Of the worker that finds hands, and of the library that it loads: it may compile WebAssembly, which the page may not.
constexpr auto hands_policy =
    "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

// Of every answer.
const httplib::Headers always = {{"Content-Security-Policy", policy},
                                 {"X-Content-Type-Options", "nosniff"},
                                 {"X-Frame-Options", "DENY"},
                                 {"Referrer-Policy", "no-referrer"},
                                 {"Cross-Origin-Opener-Policy", "same-origin"},
                                 {"Cross-Origin-Resource-Policy", "same-origin"}};

void send_asset(const httplib::Request& request, httplib::Response& response, const WebAsset& asset) {
  response.set_header("ETag", std::string(asset.etag));
  response.set_header("Cache-Control", "no-cache");
  response.set_header("Vary", "Accept-Encoding");
  if (request.get_header_value("If-None-Match").find(asset.etag) != std::string::npos) {
    response.status = 304;
    return;
  }
  const bool gzip = takes_gzip(request);
  if (gzip) response.set_header("Content-Encoding", "gzip");
  send(response, std::make_shared<const std::string>(gzip ? std::string(asset.gzip) : gunzipped(asset.gzip)),
       std::string(asset.mime));
}

// A file of the model that finds hands: the page's own worker, or what is installed.
void send_hands(const httplib::Request& request, httplib::Response& response, const WebAsset* asset) {
  response.headers.erase("Content-Security-Policy");
  response.set_header("Content-Security-Policy", hands_policy);
  if (asset) return send_asset(request, response, *asset);
  const auto name = request.path.substr(request.path.rfind('/') + 1);
  const auto type = hand_model_type(name);
  const auto folder = hand_model_folder();
  if (!folder || !type)
    return send_answer(request, response, api_error(404, fmt::format("there is nothing at {}", request.path)));
  send_media(request, response, {(*folder / name).string(), *type});
}

const WebAsset* find_asset(std::string_view path) {
  for (const auto& asset : web_assets())
    if (asset.path == path) return &asset;
  return nullptr;
}

// The library's routes and answers. Its own ways of accepting and reading are not used: they have no limits.
class Library : public httplib::Server {
 public:
  Library() {
    // Not SO_REUSEPORT, with which a second server would take half of the first one's connections.
    set_socket_options([](socket_t socket) {
      const int yes = 1;
      ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    });
    set_tcp_nodelay(true);
  }
  ~Library() override { close(); }

  /// The port; 0: it cannot be had.
  int bind(const std::string& address, int port) {
    const int bound = port == 0 ? bind_to_any_port(address) : bind_to_port(address, port) ? port : 0;
    if (bound <= 0) return 0;
    // Again, for the library has a backlog of 5.
    ::listen(svr_sock_, DoorLimits::backlog);
    ::fcntl(svr_sock_, F_SETFL, O_NONBLOCK);
    return bound;
  }
  int listening() const { return svr_sock_; }
  /// Answers that are sent bit by bit end as well.
  void close() {
    if (const int socket = svr_sock_.exchange(INVALID_SOCKET); socket != INVALID_SOCKET) ::close(socket);
  }

  bool answer(HttpStream& stream, bool last) {
    bool closes = false;
    return process_request(stream, last, closes, nullptr) && !closes;
  }
};

// "; port 8082 is free (--port 8082)", if one of the next is.
std::string free_port_after(const std::string& address, int port) {
  for (int next = port + 1; port > 0 && next <= std::min(port + ports_tried, 65535); ++next)
    if (Library().bind(address, next) != 0) return fmt::format("; port {0} is free (--port {0})", next);
  return "";
}

std::string always_lines() {
  std::string lines;
  for (const auto& [name, value] : always) lines += fmt::format("{}: {}\r\n", name, value);
  return lines;
}

// Of an answer in chunks, after which the connection ends.
std::string head_of_stream() {
  return fmt::format(
      "HTTP/1.1 200 OK\r\n{}Cache-Control: no-store\r\nContent-Type: text/event-stream\r\n"
      "Transfer-Encoding: chunked\r\nConnection: close\r\n\r\n",
      always_lines());
}

// An answer that the library has no part in.
std::string written(const HttpAnswer& answer) {
  const auto body = answer.sentence.empty() ? std::string() : api_error(answer.status, answer.sentence).body;
  auto text =
      fmt::format("HTTP/1.1 {} {}\r\n{}", answer.status, answer.status < 400 ? "See Other" : "Refused", always_lines());
  for (const auto& [name, value] : answer.headers) text += fmt::format("{}: {}\r\n", name, value);
  return text + fmt::format(
                    "Cache-Control: no-store\r\nContent-Type: application/json\r\nContent-Length: {}\r\n"
                    "Connection: close\r\n\r\n{}",
                    body.size(), body);
}

}  // namespace

class InspectorServer::Impl {
 public:
  Impl(std::vector<std::string> paths, std::shared_ptr<LiveSessions> sessions)
      : api_(std::move(paths), drawn_frames(), replayed_what_if()), sessions_(std::move(sessions)) {
    server_.set_payload_max_length(HttpLimits::body);
    server_.set_keep_alive_timeout(DoorLimits::idle.count());
    server_.set_keep_alive_max_count(1000);
    server_.set_default_headers(always);
    server_.Get("/api/live", [this](const httplib::Request& request, httplib::Response& response) {
      if (live_ && !request.has_param("run"))
        send_no_records(request, response);
      else
        send_growth(request, response);
    });
    if (sessions_) {
      sessions_->publish_by([this](const std::string& name, const std::string& log) { return api_.add(name, log); });
      api_.ask_whether_open([this](const std::string& log) { return sessions_->is_live(log); });
      live_ = std::make_unique<LiveApi>(sessions_);
      add_live_routes(server_, *live_);
      streams_ = std::make_unique<RecordStreams>(sessions_, stopping_);
    }
    server_.Get(R"(/api/runs/[^/]+/media/[^/]+)", [this](const httplib::Request& request, httplib::Response& response) {
      const auto found = api_.media_file(request.target);
      if (const auto* refused = std::get_if<ApiResponse>(&found)) return send_answer(request, response, *refused);
      send_media(request, response, std::get<ServedMedia>(found));
    });
    server_.Get("/api/.*", [this](const httplib::Request& request, httplib::Response& response) {
      send_answer(request, response, api_.get(request.target));
    });
    server_.Get(R"(/hands/[\w.]+)", [](const httplib::Request& request, httplib::Response& response) {
      send_hands(request, response, find_asset(request.path));
    });
    server_.Get("/.*", [](const httplib::Request& request, httplib::Response& response) {
      // The page shows every run; which one is its own affair.
      const bool page = request.path == "/" || request.path == "/live" || request.path.starts_with("/live/") ||
                        request.path.starts_with("/r/") || request.path.starts_with("/diff/");
      if (const auto* asset = find_asset(page ? "/index.html" : request.path))
        return send_asset(request, response, *asset);
      // A reader gets a page that says so.
      const auto* index = find_asset("/index.html");
      if (index && request.get_header_value("Accept").find("text/html") != std::string::npos) {
        send_asset(request, response, *index);
        response.status = 404;
      } else {
        send_answer(request, response, api_error(404, fmt::format("there is nothing at {}", request.path)));
      }
    });
    const auto content_type = [](const httplib::Request& request) { return request.get_header_value("Content-Type"); };
    server_.Post("/api/what-if", [this, content_type](const httplib::Request& request, httplib::Response& response) {
      send_answer(request, response, api_.post(request.target, content_type(request), request.body));
    });
    server_.Post("/api/dropped", [this, content_type](const httplib::Request& request, httplib::Response& response) {
      send_answer(request, response, api_.post(request.target, content_type(request), request.body));
    });
    server_.Put("/api/runs/[^/]+/notes",
                [this, content_type](const httplib::Request& request, httplib::Response& response) {
                  send_answer(request, response, api_.put(request.target, content_type(request), request.body));
                });
    const auto nothing_to_write = [](const httplib::Request& request, httplib::Response& response) {
      send_answer(request, response, api_error(405, "this address can only be read"));
    };
    server_.Post(".*", nothing_to_write);
    server_.Put(".*", nothing_to_write);
    server_.Delete(".*", nothing_to_write);
    server_.set_error_handler([](const httplib::Request& request, httplib::Response& response) {
      if (response.body.empty() && !response.content_provider_)
        send_answer(request, response, api_error(response.status, "the request could not be answered"));
    });
  }

  Result<int> listen(const std::string& address, int port, const std::string& token) {
    const int bound = server_.bind(address, port);
    if (bound == 0)
      return Error{fmt::format("{}:{}", address, port),
                   fmt::format("cannot be listened on: in use, or not an address of this machine{}",
                               free_port_after(address, port))};
    access_.emplace(address, bound, token);
    return bound;
  }

  void run() {
    running_ = true;
    if (!stopping_) {
      api_.start_preparing();
      door_.run(server_.listening());
      server_.close();
      api_.stop_preparing();
    }
    running_ = false;
  }
  void stop() {
    api_.stop();
    stopping_ = true;
    if (sessions_) sessions_->end();
    door_.stop();
    while (running_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

 private:
  // Whoever asks for the records of a session, and can have them, is served by the streams.
  bool follow(const HttpHead& head, int socket, std::function<void()> done) {
    const auto [path, query] = split_target(head.target);
    if (!streams_ || head.method != "GET" || path != "/api/live" || query.contains("run")) return false;
    auto wish = record_wish(head.target, head.value("Last-Event-ID"), *sessions_);
    if (!std::holds_alternative<RecordWish>(wish)) return false;
    auto seat = seats_.take();
    if (!seat) return false;
    streams_->add(socket, head_of_stream(), std::get<RecordWish>(std::move(wish)),
                  [seat, done = std::move(done)]() mutable {
                    seat.reset();
                    done();
                  });
    return true;
  }

  // Whoever cannot have them, or wants the head of the answer alone.
  void send_no_records(const httplib::Request& request, httplib::Response& response) {
    const auto wish = record_wish(request.target, request.get_header_value("Last-Event-ID"), *sessions_);
    if (const auto* refused = std::get_if<ApiResponse>(&wish)) return send_answer(request, response, *refused);
    if (request.method != "HEAD") return send_answer(request, response, no_seat());
    response.set_header("Cache-Control", "no-store");
    response.set_header("Content-Type", "text/event-stream");
  }

  // Tells how far a run has come whenever it has come further, until it is complete or nobody listens.
  void send_growth(const httplib::Request& request, httplib::Response& response) {
    const auto id = request.get_param_value("run");
    if (const auto first = api_.growth(id); first.status != 200) return send_answer(request, response, first);
    const auto seat = seats_.take();
    if (!seat) return send_answer(request, response, no_seat());
    response.set_header("Cache-Control", "no-store");
    response.set_chunked_content_provider(
        "text/event-stream", [this, id, seat, told = std::string()](std::size_t, httplib::DataSink& sink) mutable {
          const auto growth = api_.growth(id);
          if (growth.status != 200) return sink.done(), true;
          if (growth.body != told) {
            told = growth.body;
            const auto event = fmt::format("event: grown\ndata: {}\n\n", told);
            if (!sink.write(event.data(), event.size())) return false;
          }
          if (growth.body.find("\"complete\":true") != std::string::npos) return sink.done(), true;
          std::this_thread::sleep_for(look_every);
          return !stopping_ && sink.is_writable();
        });
  }

  HttpDoor::Rules rules() {
    return {.check = [this](const HttpHead& head) { return access_->check(head); },
            .written = written,
            .answer = [this](HttpStream& stream, bool last) { return server_.answer(stream, last); },
            .threads = StreamSeats::most + WaitingAnswers::most + other_threads,
            .follow = [this](const HttpHead& head, int socket,
                             std::function<void()> done) { return follow(head, socket, std::move(done)); },
            .finish =
                [this] {
                  if (streams_) streams_->finish();
                }};
  }

  InspectorApi api_;
  const std::shared_ptr<LiveSessions> sessions_;  // null: no live sessions
  std::unique_ptr<LiveApi> live_;                 // of these
  Library server_;
  std::optional<Access> access_;
  StreamSeats seats_;
  std::atomic<bool> running_ = false, stopping_ = false;
  std::unique_ptr<RecordStreams> streams_;  // of live sessions
  HttpDoor door_{rules()};
};

InspectorServer::InspectorServer(std::vector<std::string> paths, std::shared_ptr<LiveSessions> sessions)
    : impl_(std::make_unique<Impl>(std::move(paths), std::move(sessions))) {}
InspectorServer::~InspectorServer() = default;
Result<int> InspectorServer::listen(const std::string& address, int port, const std::string& token) {
  return impl_->listen(address, port, token);
}
void InspectorServer::run() { impl_->run(); }
void InspectorServer::stop() { impl_->stop(); }

}  // namespace continua
