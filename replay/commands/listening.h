// The address that a command serves at, and who may ask there.
#pragma once

#include <string>

#include "continua/core/result.h"

namespace CLI {
class App;
}

namespace continua {

class InspectorServer;

struct ListenOptions {
  std::string address = "127.0.0.1";
  std::string token;  ///< "random": one is drawn; empty: one is drawn where other machines can reach the address
};

struct ListeningPlace {
  std::string base, query;
  /// The address of a page for a browser on this machine, with the token.
  std::string page(const std::string& path) const { return base + path + query; }
};

/// `port`: 0 takes a free one. Warns on standard error where other machines can reach it.
Result<ListeningPlace> listen(InspectorServer& server, const ListenOptions& options, int port);

inline constexpr auto describe_durable =
    "an event is taken when it is on the disk, safe from the end of the machine; otherwise it is there within a second";

void describe_listening(CLI::App& command, ListenOptions& options);

}  // namespace continua
