// Writes an MCAP file: chunks compressed with zstd, and an index of all that is in the file.
#pragma once

#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "continua/replay/mcap/mcap_records.h"

namespace continua {

class McapWriter {
 public:
  /// `out` must outlive this, and is at the beginning of a file.
  McapWriter(std::ostream& out, std::string_view profile, std::string_view library);

  /// The number of the channel of this topic, the same for the same topic. Channels with one schema's name share the
  /// schema.
  std::uint16_t channel(const McapChannel& channel);

  /// A message; its time is in nanoseconds.
  void message(std::uint16_t channel, std::uint64_t t_ns, std::string_view data);

  void attach(const std::string& name, const std::string& media_type, std::string_view data);
  void metadata(const std::string& name, const McapEntries& entries);

  /// The end of the file. Nothing may be written after it.
  void finish();

 private:
  struct Span {
    std::uint64_t from_ns = 0, to_ns = 0;
    bool any = false;
    void add(std::uint64_t t_ns);
  };

  void put(std::string_view bytes);
  void put_record(McapOp op, std::string_view content);
  void finish_chunk();
  void summary_group(McapOp op, const std::vector<std::string>& records, std::string& summary, std::string& offsets,
                     std::uint64_t begin) const;
  std::string statistics() const;

  std::ostream& out_;
  std::uint64_t at_ = 0;  // bytes written
  std::map<std::string, std::uint16_t> schema_numbers_, channel_numbers_;
  std::vector<std::string> schemas_, channels_, chunk_indexes_, attachment_indexes_, metadata_indexes_;
  std::map<std::uint16_t, std::uint32_t> counts_;  // messages of each channel
  std::string chunk_;
  std::map<std::uint16_t, std::string> indexes_;  // of the messages in chunk_
  Span chunk_span_, span_;
};

}  // namespace continua
