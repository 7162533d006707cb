// The parts of MCAP's format (https://mcap.dev/spec) that reader and writer share.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace continua {

/// The first and the last bytes of a file.
inline constexpr std::string_view mcap_magic = "\x89MCAP0\r\n";

/// The first byte of a record; the length of its content follows, 64 bits.
enum class McapOp : std::uint8_t {
  header = 1,
  footer = 2,
  schema = 3,
  channel = 4,
  message = 5,
  chunk = 6,
  message_index = 7,
  chunk_index = 8,
  attachment = 9,
  attachment_index = 10,
  statistics = 11,
  metadata = 12,
  metadata_index = 13,
  summary_offset = 14,
  data_end = 15,
};

constexpr std::uint8_t op_number(McapOp op) { return static_cast<std::uint8_t>(op); }

inline constexpr std::size_t mcap_record_head = 9;  ///< bytes of the operation and the length

struct McapSchema {
  std::string name, encoding, data;
};

struct McapChannel {
  std::string topic, message_encoding;
  McapSchema schema;  ///< with an empty name where there is none
};

using McapEntries = std::vector<std::pair<std::string, std::string>>;

}  // namespace continua
