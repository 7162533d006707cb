#include "continua/replay/server/http_answer.h"

#include <algorithm>

#include "continua/core/gzip.h"
#include "continua/replay/server/http_library.h"

namespace continua {
namespace {

constexpr std::size_t smallest_packed = 1024;  // shorter answers are not worth compressing

bool is_here(const httplib::Request& request) {
  return request.remote_addr == "127.0.0.1" || request.remote_addr == "::1";
}

}  // namespace

bool takes_gzip(const httplib::Request& request) {
  return request.get_header_value("Accept-Encoding").find("gzip") != std::string::npos;
}

// Through a content provider, because the library would compress a plain body once more.
void send(httplib::Response& response, std::shared_ptr<const std::string> body, const std::string& type) {
  if (body->empty()) return response.set_content("", type);
  response.set_content_provider(body->size(), type,
                                [body](std::size_t from, std::size_t size, httplib::DataSink& sink) {
                                  return sink.write(body->data() + from, std::min(size, body->size() - from)), true;
                                });
}

void send_answer(const httplib::Request& request, httplib::Response& response, ApiResponse answer) {
  response.status = answer.status;
  response.set_header("Cache-Control", "no-store");
  response.set_header("Vary", "Accept-Encoding");
  // Pictures are packed already; columns go faster as they are to where no wire is.
  const bool packs =
      answer.content_type != "image/png" && !(answer.content_type == "application/octet-stream" && is_here(request));
  if (packs && answer.body.size() >= smallest_packed && takes_gzip(request)) {
    response.set_header("Content-Encoding", "gzip");
    answer.body = gzipped(answer.body);
  }
  send(response, std::make_shared<const std::string>(std::move(answer.body)), answer.content_type);
}

}  // namespace continua
