// The addresses of live sessions on a server.
#pragma once

#include <atomic>
#include <memory>
#include <string_view>
#include <variant>

#include "continua/replay/live/live_api.h"
#include "continua/replay/server/record_streams.h"

namespace httplib {
class Server;
}  // namespace httplib

namespace continua {

/// Streams that may be open at a time.
class StreamSeats {
 public:
  static constexpr int most = 64;
  /// Gives the seat back at its end; null where all are taken.
  std::shared_ptr<void> take();

 private:
  std::atomic<int> taken_ = 0;
};

/// Everything below /api/sessions. `api` must outlive the server.
void add_live_routes(httplib::Server& server, LiveApi& api);

/// "/api/live?session=ID&after=N": every record of the session's log as it is written, with N < `n` or after that in
/// the header Last-Event-ID (event `record`, its `id` the number); how its time goes whenever that changes (event
/// `clock`, {"t", "running", "speed", "viewers"}); its end (event `ended`, as of the session's address). Without
/// `session` the live one that was begun last, or will be begun next. `last_id`: that header; or the refusal.
std::variant<RecordWish, ApiResponse> record_wish(std::string_view target, std::string_view last_id,
                                                  const LiveSessions& sessions);
/// The refusal where no seat is left.
ApiResponse no_seat();

}  // namespace continua
