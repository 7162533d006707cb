#include "continua/core/gzip_blocks.h"

#include <zlib.h>

#include <array>

#include "continua/core/result.h"

namespace continua {
namespace {

constexpr int level = 6;         // zlib's usual one
constexpr int raw_window = -15;  // zlib's window bits for packed bytes without a header
constexpr std::size_t trailer_bytes = 8, most_block_bytes = 1 << 16;

// A gzip header with an extra field BC of two bytes: no name, no time, an unknown system. The length comes after it.
constexpr std::array<unsigned char, 16> header{0x1f, 0x8b, 8, 4, 0, 0, 0, 0, 0, 0xff, 6, 0, 'B', 'C', 2, 0};

void put_number(std::string& out, std::uint32_t number, int bytes) {
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(number >> (8 * i) & 0xffU);
}

std::uint32_t number_in(std::string_view bytes) {
  std::uint32_t number = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[i]);
  return number;
}

std::string deflated(std::string_view text) {
  z_stream stream{};
  require(deflateInit2(&stream, level, Z_DEFLATED, raw_window, 8, Z_DEFAULT_STRATEGY) == Z_OK, "memory for zlib");
  std::string out(deflateBound(&stream, text.size()), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  require(deflate(&stream, Z_FINISH) == Z_STREAM_END, "room for a packed block");
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string block_of(std::string_view text) {
  const auto packed = deflated(text);
  const auto bytes = block_head_bytes + packed.size() + trailer_bytes;
  require(bytes <= most_block_bytes, "a block is so short that its length can be told");
  std::string block(header.begin(), header.end());
  put_number(block, static_cast<std::uint32_t>(bytes - 1), 2);
  block += packed;
  const auto check = crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
  put_number(block, static_cast<std::uint32_t>(check), 4);
  put_number(block, static_cast<std::uint32_t>(text.size()), 4);
  return block;
}

}  // namespace

std::string GzipBlocks::add(std::string_view part) {
  held_.append(part);
  std::string out;
  std::size_t from = 0;
  while (held_.size() - from > longest_block_text) {
    const auto most = std::string_view(held_).substr(from, longest_block_text);
    const auto line_end = most.rfind('\n');
    const auto length = line_end == most.npos ? most.size() : line_end + 1;
    out += block_of(most.substr(0, length));
    from += length;
  }
  held_.erase(0, from);
  return out;
}

std::string GzipBlocks::finish() {
  auto out = held_.empty() ? std::string() : block_of(held_);
  held_.clear();
  return out + block_of("");
}

std::optional<std::uint32_t> block_bytes_of(std::string_view head) {
  constexpr std::size_t time_at = 4, time_end = 10;  // the time, the level and the system are of no interest
  if (head.size() < block_head_bytes) return std::nullopt;
  for (std::size_t i = 0; i < header.size(); ++i)
    if ((i < time_at || i >= time_end) && static_cast<unsigned char>(head[i]) != header[i]) return std::nullopt;
  const auto bytes = number_in(head.substr(header.size(), 2)) + 1;
  if (bytes < block_head_bytes + trailer_bytes) return std::nullopt;
  return bytes;
}

std::uint32_t text_bytes_of(std::string_view tail) { return number_in(tail); }

}  // namespace continua
