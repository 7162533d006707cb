// Answers of the inspector's addresses as a server sends them.
#pragma once

#include <memory>
#include <string>

#include "continua/replay/inspector/inspector_api.h"

namespace httplib {
struct Request;
struct Response;
}  // namespace httplib

namespace continua {

bool takes_gzip(const httplib::Request& request);
/// Sends the body as it is, past the processing of the library.
void send(httplib::Response& response, std::shared_ptr<const std::string> body, const std::string& type);
/// Packed, if that is worth it and the browser takes it. Not to be kept.
void send_answer(const httplib::Request& request, httplib::Response& response, ApiResponse answer);

}  // namespace continua
