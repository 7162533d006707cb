// Recordings as a server sends them: whole, or the part that a player asks for.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "continua/replay/inspector/inspector_api.h"

namespace httplib {
struct Request;
struct Response;
}  // namespace httplib

namespace continua {

/// Bytes of a file, [from, to).
struct ByteRange {
  std::uint64_t from = 0, to = 0;
};

/// The most bytes in the answer to a request for a part: a player asks for the next part when it needs it, so that one
/// that waits in mid-film keeps no thread of the server.
inline constexpr std::uint64_t most_media_part = std::uint64_t{1} << 20;

/// The part of a file of `size` bytes that the value of the header Range wants: one range of bytes. Nothing: it wants
/// something else, and the whole file is the answer. An empty range: the file has no such bytes.
std::optional<ByteRange> wanted_range(std::string_view range, std::uint64_t size);

/// 200 with the file, 206 with the part wanted, 416 where it has none.
void send_media(const httplib::Request& request, httplib::Response& response, const ServedMedia& media);

}  // namespace continua
