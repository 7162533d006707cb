// Who may ask: whoever is on this machine, by its own names, and elsewhere whoever has a token.
#pragma once

#include <optional>
#include <string>

#include "continua/replay/server/http_head.h"

namespace continua {

/// Whether only this machine can reach the address.
bool is_loopback(const std::string& address);

/// 32 letters and digits that nobody can guess.
std::string new_token();

class Access {
 public:
  /// `address`, `port`: listened on. `token`: empty: none is needed.
  Access(std::string address, int port, std::string token);

  /// Why a request is not answered, or the way to the same address without its token, which is a cookie from then on.
  /// A page elsewhere may reach the port through its visitor's browser: by its own name made to point here (the host is
  /// then that name), or openly (the browser then says so).
  std::optional<HttpAnswer> check(const HttpHead& head) const;

 private:
  std::optional<HttpAnswer> check_token(const HttpHead& head) const;

  std::string address_, token_, cookie_;
};

}  // namespace continua
