#include "continua/replay/commands/listening.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cctype>

#include "continua/replay/server/access.h"
#include "continua/replay/server/inspector_server.h"
#include "continua/replay/terminal/terminal.h"

namespace continua {
namespace {

constexpr std::size_t shortest_token = 16, longest_token = 128;

std::string fault_of_token(const std::string& token) {
  const bool fit =
      token.size() >= shortest_token && token.size() <= longest_token &&
      std::all_of(token.begin(), token.end(), [](unsigned char c) { return std::isalnum(c) || c == '-' || c == '_'; });
  return fit || token == "random"
             ? std::string()
             : fmt::format("expected {} to {} letters, digits, _ or -, or random", shortest_token, longest_token);
}

// An address that a browser on this machine can be given.
std::string host_of(const std::string& address) {
  if (address == "0.0.0.0") return "127.0.0.1";
  if (address == "::") return "[::1]";
  return address.find(':') == std::string::npos ? address : "[" + address + "]";
}

}  // namespace

Result<ListeningPlace> listen(InspectorServer& server, const ListenOptions& options, int port) {
  const bool open = !is_loopback(options.address);
  const auto token = options.token == "random" || (open && options.token.empty()) ? new_token() : options.token;
  const auto bound = server.listen(options.address, port, token);
  if (!bound) return bound.error();
  if (open)
    report_warning({fmt::format("--bind {}", options.address),
                    "other machines can reach this server: whoever has the token may read the runs, talk to the avatar "
                    "and write notes; nothing on the way is encrypted"});
  return ListeningPlace{fmt::format("http://{}:{}", host_of(options.address), *bound),
                        token.empty() ? "" : "?token=" + token};
}

void describe_listening(CLI::App& command, ListenOptions& options) {
  command
      .add_option("--bind", options.address,
                  "address to listen on; where other machines can reach it, requests need a token")
      ->capture_default_str();
  command
      .add_option("--token", options.token,
                  "a secret that requests must have, in the address or as 'Authorization: Bearer TOKEN'; random draws "
                  "one and prints it")
      ->check(fault_of_token);
}

}  // namespace continua
