#include "continua/replay/server/inspector_server.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <chrono>
#include <thread>

#include <fmt/format.h>

#include "continua/core/gzip.h"
#include "continua/replay/experiment/what_if_session.h"
#include "continua/replay/inspector/inspector_api.h"
#include "continua/replay/pictures/frame_cache.h"
#include "continua/replay/server/http_answer.h"
#include "continua/replay/server/live_routes.h"
#include "continua/web/assets.h"

// After Eigen, whose names are macros of a header of the library's.
#include <httplib.h>

namespace continua {
namespace {

constexpr std::size_t largest_body = std::size_t{1} << 20;
constexpr int other_threads = 16;
constexpr std::chrono::milliseconds look_every{200};  // at a run that is being written

// Only this server's own answers may be loaded, run, framed or sent to.
constexpr auto policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

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

const WebAsset* find_asset(std::string_view path) {
  for (const auto& asset : web_assets())
    if (asset.path == path) return &asset;
  return nullptr;
}

// "[::1]:8080" -> "[::1]", "localhost:8080" -> "localhost"
std::string host_without_port(const std::string& host) {
  const auto colon = host.rfind(':');
  const auto bracket = host.rfind(']');
  const bool has_port = colon != std::string::npos && (bracket == std::string::npos || colon > bracket);
  return has_port ? host.substr(0, colon) : host;
}

bool is_number_address(const std::string& host) {
  return !host.empty() && (host.front() == '[' || std::all_of(host.begin(), host.end(), [](unsigned char c) {
                             return std::isdigit(c) || c == '.';
                           }));
}

}  // namespace

class InspectorServer::Impl {
 public:
  Impl(std::vector<std::string> paths, std::shared_ptr<LiveSessions> sessions)
      : api_(std::move(paths), drawn_frames(), replayed_what_if()), sessions_(std::move(sessions)) {
    server_.set_payload_max_length(largest_body);
    server_.set_tcp_nodelay(true);
    server_.set_read_timeout(2);
    const auto guard = [this](httplib::Server::Handler handler) -> httplib::Server::Handler {
      return [this, handler = std::move(handler)](const httplib::Request& request, httplib::Response& response) {
        if (!refuses(request, response)) handler(request, response);
      };
    };
    server_.set_keep_alive_timeout(2);
    server_.set_default_headers({{"Content-Security-Policy", policy},
                                 {"X-Content-Type-Options", "nosniff"},
                                 {"Referrer-Policy", "no-referrer"},
                                 {"Cross-Origin-Opener-Policy", "same-origin"},
                                 {"Cross-Origin-Resource-Policy", "same-origin"}});
    server_.set_pre_routing_handler([this](const httplib::Request& request, httplib::Response& response) {
      using enum httplib::Server::HandlerResponse;
      // A request answered before its body is read leaves the body to be taken for the next request.
      if (has_body(request)) return Unhandled;
      if (refuses(request, response)) return Handled;
      return live_ && answer_without_body(request, response, *live_) ? Handled : Unhandled;
    });
    server_.new_task_queue = [] { return new httplib::ThreadPool(StreamSeats::most + other_threads); };
    server_.Get("/api/live", [this](const httplib::Request& request, httplib::Response& response) {
      if (live_ && !request.has_param("run"))
        send_records(request, response, *live_, seats_, stopping_);
      else
        send_growth(request, response);
    });
    if (sessions_) {
      sessions_->publish_by([this](const std::string& name, const std::string& log) { return api_.add(name, log); });
      api_.ask_whether_open([this](const std::string& log) { return sessions_->is_live(log); });
      live_ = std::make_unique<LiveApi>(sessions_);
      add_live_routes(server_, *live_, guard);
    }
    server_.Get("/api/.*", [this](const httplib::Request& request, httplib::Response& response) {
      send_answer(request, response, api_.get(request.target));
    });
    server_.Get("/.*", [](const httplib::Request& request, httplib::Response& response) {
      // The page shows every run; which one is its own affair.
      const bool page = request.path == "/" || request.path == "/live" || request.path.starts_with("/live/") ||
                        request.path.starts_with("/r/") || request.path.starts_with("/diff/");
      if (const auto* asset = find_asset(page ? "/index.html" : request.path))
        send_asset(request, response, *asset);
      else
        send_answer(request, response, api_error(404, fmt::format("there is nothing at {}", request.path)));
    });
    const auto content_type = [](const httplib::Request& request) { return request.get_header_value("Content-Type"); };
    server_.Post("/api/what-if",
                 guard([this, content_type](const httplib::Request& request, httplib::Response& response) {
                   send_answer(request, response, api_.post(request.target, content_type(request), request.body));
                 }));
    server_.Put("/api/runs/[^/]+/notes",
                guard([this, content_type](const httplib::Request& request, httplib::Response& response) {
                  send_answer(request, response, api_.put(request.target, content_type(request), request.body));
                }));
    const auto nothing_to_write = guard([](const httplib::Request& request, httplib::Response& response) {
      send_answer(request, response, api_error(405, "this address can only be read"));
    });
    server_.Post(".*", nothing_to_write);
    server_.Put(".*", nothing_to_write);
    server_.Delete(".*", nothing_to_write);
    server_.set_error_handler([](const httplib::Request& request, httplib::Response& response) {
      if (response.body.empty() && !response.content_provider_)
        send_answer(request, response, api_error(response.status, "the request could not be answered"));
    });
  }

  Result<int> listen(const std::string& address, int port) {
    address_ = address;
    const int bound = port == 0 ? server_.bind_to_any_port(address) : server_.bind_to_port(address, port) ? port : -1;
    if (bound <= 0)
      return Error{fmt::format("{}:{}", address, port),
                   "cannot be listened on: in use, or not an address of this machine"};
    return bound;
  }

  void run() {
    running_ = true;
    if (!stopping_) {
      api_.start_preparing();
      server_.listen_after_bind();
      api_.stop_preparing();
    }
    running_ = false;
  }
  void stop() {
    api_.stop();
    stopping_ = true;
    if (sessions_) sessions_->end();
    // The library does not stop a server that is only about to listen.
    for (; running_; std::this_thread::sleep_for(std::chrono::milliseconds(1))) server_.stop();
  }

 private:
  // Tells how far a run has come whenever it has come further, until it is complete or nobody listens.
  void send_growth(const httplib::Request& request, httplib::Response& response) {
    const auto id = request.get_param_value("run");
    if (const auto first = api_.growth(id); first.status != 200) return send_answer(request, response, first);
    const auto seat = seats_.take();
    if (!seat)
      return send_answer(request, response,
                         api_error(503, fmt::format("{} runs are being followed already", StreamSeats::most)));
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

  static bool has_body(const httplib::Request& request) {
    const auto length = request.get_header_value("Content-Length");
    return request.has_header("Transfer-Encoding") || !(length.empty() || length == "0");
  }

  bool refuses(const httplib::Request& request, httplib::Response& response) const {
    const auto why = refusal(request);
    if (!why.empty()) send_answer(request, response, api_error(403, why));
    return !why.empty();
  }

  // Why a request is not answered; empty when it is. A page elsewhere may reach this port through its visitor's
  // browser: by its own name made to point here (the host is then that name), or openly (the origin is then its own).
  std::string refusal(const httplib::Request& request) const {
    const auto host = request.get_header_value("Host");
    const auto name = host_without_port(host);
    const bool everywhere = address_ == "0.0.0.0" || address_ == "::";
    const bool ours = name == "localhost" || name == "127.0.0.1" || name == "[::1]" || name == address_ ||
                      name == "[" + address_ + "]" || (everywhere && is_number_address(name));
    if (!ours) return fmt::format("requests for the host '{}' are not answered", host);
    const auto origin = request.get_header_value("Origin");
    if (request.has_header("Origin") && origin != "http://" + host)
      return fmt::format("requests from '{}' are not answered", origin);
    return {};
  }

  InspectorApi api_;
  const std::shared_ptr<LiveSessions> sessions_;  // null: no live sessions
  std::unique_ptr<LiveApi> live_;                 // of these
  httplib::Server server_;
  std::string address_;
  StreamSeats seats_;
  std::atomic<bool> running_ = false, stopping_ = false;
};

InspectorServer::InspectorServer(std::vector<std::string> paths, std::shared_ptr<LiveSessions> sessions)
    : impl_(std::make_unique<Impl>(std::move(paths), std::move(sessions))) {}
InspectorServer::~InspectorServer() = default;
Result<int> InspectorServer::listen(const std::string& address, int port) { return impl_->listen(address, port); }
void InspectorServer::run() { impl_->run(); }
void InspectorServer::stop() { impl_->stop(); }

}  // namespace continua
