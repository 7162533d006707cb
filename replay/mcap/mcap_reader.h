// Reads the messages of an MCAP file one after the other, whether it has an index or not. Chunks may be compressed with
// zstd.
#pragma once

#include <cstdint>
#include <functional>
#include <istream>
#include <string>
#include <string_view>

#include "continua/core/result.h"
#include "continua/replay/mcap/mcap_records.h"

namespace continua {

struct McapMessage {
  const McapChannel& channel;
  std::uint64_t t_ns;  ///< when it was logged
  std::string_view data;
};

/// The users of a file's parts. An error of one ends the reading, and gets the message's place.
struct McapUse {
  std::function<bool(const McapChannel&)> wanted;  ///< whether messages of the channel are to be told
  std::function<Outcome(const McapMessage&)> message;
  std::function<Outcome(const std::string& name, const McapEntries&)> metadata;
};

/// Whether the file is one by its name or by its first bytes.
bool is_mcap_file(const std::string& path);

/// Reads `in`, the file called `name`, to the end of its data. Memory is needed for one chunk. An error has the byte
/// at which the broken record begins: "FILE: byte 9", of a record in a chunk also that of the chunk.
Outcome read_mcap(std::istream& in, const std::string& name, const McapUse& use);

}  // namespace continua
