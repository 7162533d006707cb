// The compression and the checksum of MCAP's chunks.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace continua {

/// CRC32 as MCAP, zlib and PNG have it.
std::uint32_t crc32_of(std::string_view bytes);

/// The bytes compressed with zstd. The same bytes give the same, with the same version of zstd.
std::string zstd_packed(std::string_view bytes);

/// The bytes that were compressed; nothing if they are not `size` many, or damaged. Memory grows with the bytes that
/// are there, not with `size`.
std::optional<std::string> zstd_unpacked(std::string_view packed, std::uint64_t size);

}  // namespace continua
