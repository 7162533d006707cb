#include "continua/replay/server/access.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <fmt/format.h>

#include "continua/core/result.h"

namespace continua {
namespace {

constexpr std::string_view in_address = "token=";

// "[::1]:8080" -> "[::1]", "localhost:8080" -> "localhost"
std::string_view host_without_port(std::string_view host) {
  const auto colon = host.rfind(':');
  const auto bracket = host.rfind(']');
  const bool has_port = colon != std::string::npos && (bracket == std::string::npos || colon > bracket);
  return has_port ? host.substr(0, colon) : host;
}

bool is_number_address(std::string_view host) {
  return !host.empty() && (host.front() == '[' || std::all_of(host.begin(), host.end(), [](unsigned char c) {
                             return std::isdigit(c) || c == '.';
                           }));
}

// Takes as long whatever differs.
bool is_secret(std::string_view given, std::string_view secret) {
  if (given.size() != secret.size()) return false;
  int different = 0;
  for (std::size_t i = 0; i < given.size(); ++i) different |= given[i] ^ secret[i];
  return different == 0;
}

// The part of `text` between two separators that begins with `name`, without it.
std::optional<std::string_view> part_of(std::string_view text, std::string_view separator, std::string_view name) {
  while (!text.empty()) {
    const auto end = text.find(separator);
    const auto part = text.substr(0, end);
    if (part.starts_with(name)) return part.substr(name.size());
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + separator.size());
  }
  return std::nullopt;
}

std::string without_token(std::string_view target) {
  const auto question = target.find('?');
  std::string kept(target.substr(0, question));
  char separator = '?';
  for (auto query = target.substr(question + 1); !query.empty();) {
    const auto end = query.find('&');
    const auto part = query.substr(0, end);
    query.remove_prefix(end == std::string_view::npos ? query.size() : end + 1);
    if (part.starts_with(in_address)) continue;
    kept += separator;
    kept += part;
    separator = '&';
  }
  return kept;
}

}  // namespace

bool is_loopback(const std::string& address) {
  return address == "localhost" || address == "::1" || address.starts_with("127.");
}

std::string new_token() {
  std::array<unsigned char, 16> drawn;
  require(::getrandom(drawn.data(), drawn.size(), 0) == static_cast<ssize_t>(drawn.size()), "no random bytes");
  return fmt::format("{:02x}", fmt::join(drawn, ""));
}

Access::Access(std::string address, int port, std::string token)
    : address_(std::move(address)), token_(std::move(token)), cookie_(fmt::format("continua_{}=", port)) {}

std::optional<HttpAnswer> Access::check(const HttpHead& head) const {
  const auto host = head.value("Host");
  const auto name = host_without_port(host);
  const bool everywhere = address_ == "0.0.0.0" || address_ == "::";
  const bool ours = name == "localhost" || name == "127.0.0.1" || name == "[::1]" || name == address_ ||
                    name == "[" + address_ + "]" || (everywhere && is_number_address(name));
  if (!ours) return HttpAnswer{403, fmt::format("requests for the host '{}' are not answered", host), {}};
  if (const auto* origin = head.header("Origin"); origin && *origin != fmt::format("http://{}", host))
    return HttpAnswer{403, fmt::format("requests from '{}' are not answered", *origin), {}};
  const auto site = head.value("Sec-Fetch-Site");
  // A link that somebody follows may be anywhere.
  const bool followed =
      head.method == "GET" && head.value("Sec-Fetch-Mode") == "navigate" && head.value("Sec-Fetch-Dest") == "document";
  if ((site == "cross-site" || site == "same-site") && !followed)
    return HttpAnswer{403, "requests from pages elsewhere are not answered", {}};
  return token_.empty() ? std::nullopt : check_token(head);
}

std::optional<HttpAnswer> Access::check_token(const HttpHead& head) const {
  if (const auto bearer = part_of(head.value("Authorization"), ",", "Bearer "); bearer && is_secret(*bearer, token_))
    return std::nullopt;
  if (const auto kept = part_of(head.value("Cookie"), "; ", cookie_); kept && is_secret(*kept, token_))
    return std::nullopt;
  const auto question = head.target.find('?');
  const auto query = question == std::string::npos ? "" : std::string_view(head.target).substr(question + 1);
  if (const auto given = part_of(query, "&", in_address); given && is_secret(*given, token_)) {
    if (head.method != "GET" || head.target.starts_with("/api/") || head.target.starts_with("//")) return std::nullopt;
    // Lax: the address may be a link in a letter. Whatever changes something is asked for its origin.
    return HttpAnswer{303,
                      "",
                      {{"Location", without_token(head.target)},
                       {"Set-Cookie", fmt::format("{}{}; HttpOnly; SameSite=Lax; Path=/", cookie_, token_)}}};
  }
  return HttpAnswer{401,
                    "expected the token that the program printed: open the address with it, or send it as "
                    "'Authorization: Bearer TOKEN'",
                    {{"WWW-Authenticate", "Bearer"}}};
}

}  // namespace continua
