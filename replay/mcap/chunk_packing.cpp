#include "continua/replay/mcap/chunk_packing.h"

#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <memory>

#include "continua/core/result.h"

namespace continua {
namespace {

constexpr int level = 9;  // a tenth smaller than the usual 3, and still quicker than the log is read

}  // namespace

std::uint32_t crc32_of(std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::string zstd_packed(std::string_view bytes) {
  std::string packed(ZSTD_compressBound(bytes.size()), '\0');
  const auto size = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), level);
  require(ZSTD_isError(size) == 0, "zstd compresses into a buffer that is as large as it asks for");
  packed.resize(size);
  return packed;
}

std::optional<std::string> zstd_unpacked(std::string_view packed, std::uint64_t size) {
  const std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream(ZSTD_createDStream(), ZSTD_freeDStream);
  ZSTD_inBuffer in{packed.data(), packed.size(), 0};
  std::string bytes, piece(ZSTD_DStreamOutSize(), '\0');
  for (std::size_t expected = 1; expected != 0;) {
    ZSTD_outBuffer out{piece.data(), piece.size(), 0};
    const auto before = in.pos;
    expected = ZSTD_decompressStream(stream.get(), &out, &in);
    if (ZSTD_isError(expected) || (out.pos == 0 && in.pos == before)) return std::nullopt;
    bytes.append(piece, 0, out.pos);
    if (bytes.size() > size) return std::nullopt;
    if (expected == 0 && in.pos < in.size) expected = 1;  // another frame
  }
  return bytes.size() == size ? std::optional(std::move(bytes)) : std::nullopt;
}

}  // namespace continua
