#include "continua/replay/server/live_routes.h"

#include <fmt/format.h>

#include "continua/replay/log/line_scan.h"
#include "continua/replay/server/http_answer.h"
#include "continua/replay/server/http_library.h"

namespace continua {
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

std::variant<RecordWish, ApiResponse> record_wish(std::string_view target, std::string_view last_id,
                                                  const LiveSessions& sessions) {
  const auto query = split_target(target).query;
  const auto text = [&](const char* name) {
    const auto found = query.find(name);
    return found == query.end() ? std::string() : found->second;
  };
  const auto id = text("session");
  RecordWish wish{id.empty() ? sessions.newest() : sessions.find(id), 0, text("recorder")};
  if (!id.empty() && !wish.listed) return api_error(404, fmt::format("there is no session {}", in_quotes(id)));
  const auto wanted = id.empty() || last_id.empty() ? text("after") : std::string(last_id);
  const auto after = number_in<std::uint64_t>(wanted);
  if (!after && !wanted.empty())
    return api_error(400, fmt::format("'after' is {}; expected a record's number", in_quotes(wanted)));
  if (after) wish.from = *after + 1;
  return wish;
}

ApiResponse no_seat() { return api_error(503, fmt::format("{} runs are being followed already", StreamSeats::most)); }

}  // namespace continua
