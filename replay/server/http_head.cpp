#include "continua/replay/server/http_head.h"

#include <algorithm>
#include <array>
#include <charconv>

#include <fmt/format.h>

#include "continua/core/trimmed.h"

namespace continua {
namespace {

char lower(char letter) { return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter; }

bool same_word(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) { return lower(x) == lower(y); });
}

bool is_one_of(std::string_view word, const auto& words) {
  return std::any_of(words.begin(), words.end(), [&](std::string_view one) { return same_word(word, one); });
}

// RFC 9110, 5.6.2.
bool is_token(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= '0' && c <= '9') || (lower(c) >= 'a' && lower(c) <= 'z') ||
           std::string_view("!#$%&'*+-.^_`|~").find(c) != std::string_view::npos;
  });
}

bool is_visible(std::string_view text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return c > ' ' && c < '\x7f'; });
}

bool has_control_character(std::string_view text) {
  return std::any_of(text.begin(), text.end(),
                     [](char c) { return (static_cast<unsigned char>(c) < ' ' && c != '\t') || c == '\x7f'; });
}

std::optional<HttpAnswer> read_request_line(std::string_view line, HttpHead& head) {
  const auto first = line.find(' '), last = line.rfind(' ');
  const bool three = first != std::string_view::npos && last != first;
  const auto method = line.substr(0, first), version = three ? line.substr(last + 1) : "";
  const auto target = three ? line.substr(first + 1, last - first - 1) : "";
  if (!is_token(method) || !target.starts_with('/') || !is_visible(target) || !version.starts_with("HTTP/"))
    return HttpAnswer{400, "this is no request of HTTP/1.1", {}};
  if (version != "HTTP/1.1" && version != "HTTP/1.0") return HttpAnswer{505, "expected HTTP/1.1", {}};
  static constexpr std::array<std::string_view, 5> methods = {"GET", "HEAD", "POST", "PUT", "DELETE"};
  if (std::find(methods.begin(), methods.end(), method) == methods.end())
    return HttpAnswer{405, "there is nothing here to do that with", {{"Allow", "GET, HEAD, POST, PUT, DELETE"}}};
  head.method = method;
  head.target = target;
  head.keeps_alive = version == "HTTP/1.1";
  return std::nullopt;
}

std::optional<HttpAnswer> read_header_line(std::string_view line, HttpHead& head) {
  const auto colon = line.find(':');
  const auto name = line.substr(0, colon);
  if (colon == std::string_view::npos || !is_token(name) || has_control_character(line))
    return HttpAnswer{400, "a line of the head is no header", {}};
  static constexpr std::array<std::string_view, 11> single = {
      "Host",          "Origin",         "Content-Length", "Content-Type",   "Content-Encoding", "Transfer-Encoding",
      "Authorization", "Sec-Fetch-Site", "Sec-Fetch-Mode", "Sec-Fetch-Dest", "Connection"};
  if (is_one_of(name, single) && head.header(name))
    return HttpAnswer{400, fmt::format("there is more than one header {}", name), {}};
  head.headers.emplace_back(name, trimmed(line.substr(colon + 1), " \t"));
  return std::nullopt;
}

std::optional<HttpAnswer> read_length(HttpHead& head) {
  if (head.header("Transfer-Encoding")) return HttpAnswer{411, "expected a body whose Content-Length is told", {}};
  if (const auto packing = head.value("Content-Encoding"); !packing.empty() && !same_word(packing, "identity"))
    return HttpAnswer{415, "expected a body that is not packed", {}};
  const auto* length = head.header("Content-Length");
  if (!length) return std::nullopt;
  const bool digits =
      !length->empty() && std::all_of(length->begin(), length->end(), [](char c) { return c >= '0' && c <= '9'; });
  if (!digits) return HttpAnswer{400, "Content-Length is no number", {}};
  const auto problem = std::from_chars(length->data(), length->data() + length->size(), head.body).ec;
  if (problem != std::errc() || head.body > HttpLimits::body)
    return HttpAnswer{413, fmt::format("a body may have {} bytes", HttpLimits::body), {}};
  return std::nullopt;
}

}  // namespace

const std::string* HttpHead::header(std::string_view name) const {
  const auto found =
      std::find_if(headers.begin(), headers.end(), [&](const auto& header) { return same_word(header.first, name); });
  return found == headers.end() ? nullptr : &found->second;
}

std::string_view HttpHead::value(std::string_view name) const {
  const auto* found = header(name);
  return found ? std::string_view(*found) : std::string_view();
}

std::string HttpHead::text() const {
  static constexpr std::array<std::string_view, 7> done = {
      "Connection", "Content-Length", "Expect", "Content-Encoding", "Range", "If-Range", passed_range};
  auto text = fmt::format("{} {} HTTP/1.1\r\n", method, target);
  for (const auto& [name, value] : headers)
    if (!is_one_of(name, done)) text += fmt::format("{}: {}\r\n", name, value);
  if (const auto* range = header("Range"); range && !header("If-Range"))
    text += fmt::format("{}: {}\r\n", passed_range, *range);
  return text + fmt::format("Content-Length: {}\r\n\r\n", body);
}

std::variant<std::optional<std::size_t>, HttpAnswer> HeadScan::look(std::string_view text) {
  const auto too_long = [&] {
    return lines_ == 0 ? HttpAnswer{414, fmt::format("an address may have {} bytes", HttpLimits::line), {}}
                       : HttpAnswer{431,
                                    fmt::format("a head may have {} bytes and {} lines of at most {}", HttpLimits::head,
                                                HttpLimits::header_lines, HttpLimits::line),
                                    {}};
  };
  for (;;) {
    const auto end = text.find('\n', looked_);
    looked_ = end == std::string_view::npos ? text.size() : end + 1;
    if (looked_ - line_ > HttpLimits::line || looked_ > HttpLimits::head) return too_long();
    if (end == std::string_view::npos) return std::nullopt;
    if (end == line_ || text[end - 1] != '\r')
      return HttpAnswer{400, "a line of the head does not end as it should", {}};
    const bool empty = end == line_ + 1;
    line_ = looked_;
    if (empty) return std::optional(looked_);
    if (++lines_ > HttpLimits::header_lines + 1) return too_long();
  }
}

std::variant<HttpHead, HttpAnswer> read_head(std::string_view text) {
  HttpHead head;
  for (bool first = true; !text.empty(); first = false) {
    const auto end = text.find("\r\n");
    const auto line = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 2);
    if (line.empty() && !first) break;
    if (auto refused = first ? read_request_line(line, head) : read_header_line(line, head)) return *std::move(refused);
  }
  if (auto refused = read_length(head)) return *std::move(refused);
  const auto connection = head.value("Connection");
  head.keeps_alive = head.keeps_alive ? !same_word(connection, "close") : same_word(connection, "keep-alive");
  return head;
}

}  // namespace continua
