// The addresses of live sessions on a server.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "continua/replay/live/live_api.h"

namespace httplib {
class Server;
struct Request;
struct Response;
}  // namespace httplib

namespace continua {

/// Streams that may be open at a time: each has a thread.
class StreamSeats {
 public:
  static constexpr int most = 16;
  /// Gives the seat back at its end; null where all are taken.
  std::shared_ptr<void> take();

 private:
  std::atomic<int> taken_ = 0;
};

/// Decides first whether a request is answered at all.
using Guard = std::function<std::function<void(const httplib::Request&, httplib::Response&)>(
    std::function<void(const httplib::Request&, httplib::Response&)>)>;

/// Everything below /api/sessions. `api` must outlive the server.
void add_live_routes(httplib::Server& server, LiveApi& api, const Guard& guard);

/// Answers one of these requests that has no body, for which the library would wait. False for any other request.
bool answer_without_body(const httplib::Request& request, httplib::Response& response, LiveApi& api);

/// "/api/live?session=ID&after=N": every record of the session's log as it is written, with N < `n` or after that in
/// the header Last-Event-ID (event `record`, its `id` the number); how its time goes whenever that changes (event
/// `clock`, {"t", "running", "speed", "viewers"}); its end (event `ended`, as of the session's address). Without
/// `session` the live one that was begun last, or will be begun next.
void send_records(const httplib::Request& request, httplib::Response& response, const LiveApi& api, StreamSeats& seats,
                  const std::atomic<bool>& stopping);

}  // namespace continua
