#include "continua/replay/mcap/mcap_reader.h"

#include <fmt/format.h>

#include <fstream>
#include <map>

#include "continua/core/characters.h"
#include "continua/core/located_json.h"
#include "continua/replay/mcap/chunk_packing.h"
#include "continua/replay/mcap/little_endian.h"

namespace continua {
namespace {

// Readers hold a chunk in memory; writers make them of a few MiB, so that this is a file made to fill a memory.
constexpr std::uint64_t largest_chunk = std::uint64_t{1} << 28;

class McapReading {
 public:
  McapReading(std::istream& in, const std::string& name, const McapUse& use) : in_(in), name_(name), use_(use) {}

  Outcome read() {
    std::string magic(mcap_magic.size(), '\0');
    if (!fill(magic) || magic != mcap_magic) return wrong("found other bytes; expected those with which MCAP 0 begins");
    in_.seekg(0, std::ios::end);
    size_ = static_cast<std::uint64_t>(in_.tellg());
    for (at_ = magic.size(); !done_; at_ += mcap_record_head + length_)
      if (auto problem = read_record()) return problem;
    return std::nullopt;
  }

 private:
  Error wrong(std::string sentence) const {
    const auto chunk = in_chunk_ ? fmt::format(" of the chunk at byte {}", chunk_at_) : "";
    return {fmt::format("{}: byte {}{}", name_, at_, chunk), std::move(sentence)};
  }

  bool fill(std::string& bytes) {
    in_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return in_.gcount() == static_cast<std::streamsize>(bytes.size());
  }

  // Whether the content of a record of the file is needed; the others are passed over.
  static bool is_used(McapOp op) {
    return op == McapOp::schema || op == McapOp::channel || op == McapOp::message || op == McapOp::chunk ||
           op == McapOp::metadata;
  }

  Outcome read_record() {
    if (at_ == size_)
      return wrong("the file ends here; expected more records, then the end of the data: it is cut short");
    in_.clear();
    in_.seekg(static_cast<std::streamoff>(at_));
    std::string head(mcap_record_head, '\0');
    if (!fill(head)) return wrong("the file ends within a record: it is cut short");
    const auto op = take_head(head);
    if (length_ > size_ - at_ - mcap_record_head)
      return wrong(
          fmt::format("found a record of {} bytes; expected at most the {} that are left: the file is damaged or "
                      "cut short",
                      length_, size_ - at_ - mcap_record_head));
    done_ = op == McapOp::data_end || op == McapOp::footer;
    if (!is_used(op)) return std::nullopt;
    if (length_ > largest_chunk)
      return wrong(fmt::format("found a record of {} bytes; expected at most {}", length_, largest_chunk));
    std::string content(length_, '\0');
    if (!fill(content)) return wrong("the record cannot be read");
    return op == McapOp::chunk ? read_chunk(content) : use_record(op, content);
  }

  McapOp take_head(std::string_view head) {
    ByteReader bytes(head);
    const auto op = static_cast<McapOp>(bytes.number<std::uint8_t>());
    length_ = bytes.number<std::uint64_t>();
    return op;
  }

  Outcome read_chunk(std::string_view content) {
    ByteReader bytes(content);
    bytes.view(16);  // the times of the first and the last message
    const auto size = bytes.number<std::uint64_t>();
    const auto crc = bytes.number<std::uint32_t>();
    const auto compression = bytes.text();
    const auto packed = bytes.view(bytes.number<std::uint64_t>());
    if (!bytes.ok()) return wrong("the chunk ends within its members");
    if (size > largest_chunk)
      return wrong(fmt::format("found a chunk of {} bytes; expected at most {}", size, largest_chunk));
    if (compression != "" && compression != "zstd")
      return wrong(fmt::format("found a chunk compressed with {}; expected 'zstd', or none", in_quotes(compression)));
    const auto records = compression.empty() ? std::string(packed) : zstd_unpacked(packed, size);
    if (!records) return wrong(fmt::format("the chunk cannot be unpacked to its {} bytes", size));
    if (crc != 0 && crc != crc32_of(*records)) return wrong("the chunk's checksum is another one: it is damaged");
    return read_records(*records);
  }

  Outcome read_records(std::string_view records) {
    const auto chunk_length = length_;
    chunk_at_ = at_;
    in_chunk_ = true;
    ByteReader bytes(records);
    while (bytes.left() > 0) {
      at_ = bytes.at();
      const auto op = take_head(bytes.view(mcap_record_head));
      const auto content = bytes.view(length_);
      if (!bytes.ok()) return wrong("the record is longer than its chunk");
      if (auto problem = use_record(op, content)) return problem;
    }
    in_chunk_ = false;
    at_ = chunk_at_;
    length_ = chunk_length;
    return std::nullopt;
  }

  Outcome use_record(McapOp op, std::string_view content) {
    if (op == McapOp::schema) return take_schema(content);
    if (op == McapOp::channel) return take_channel(content);
    if (op == McapOp::message) return take_message(content);
    if (op == McapOp::metadata) return take_metadata(content);
    return std::nullopt;
  }

  Outcome take_schema(std::string_view content) {
    ByteReader bytes(content);
    const auto number = bytes.number<std::uint16_t>();
    McapSchema schema;
    schema.name = bytes.text();
    schema.encoding = bytes.text();
    schema.data = bytes.text();
    if (!bytes.ok()) return wrong("the schema ends within its members");
    schemas_[number] = std::move(schema);
    return std::nullopt;
  }

  Outcome take_channel(std::string_view content) {
    ByteReader bytes(content);
    const auto number = bytes.number<std::uint16_t>(), schema = bytes.number<std::uint16_t>();
    Channel channel;
    channel.channel.topic = bytes.text();
    channel.channel.message_encoding = bytes.text();
    if (!bytes.ok()) return wrong("the channel ends within its members");
    if (channels_.contains(number)) return std::nullopt;  // told again, as chunks may
    const auto found = schemas_.find(schema);
    if (schema != 0 && found == schemas_.end())
      return wrong(fmt::format("found a channel with the schema {}; expected one that the file has before it", schema));
    if (schema != 0) channel.channel.schema = found->second;
    channel.wanted = use_.wanted(channel.channel);
    channels_[number] = std::move(channel);
    return std::nullopt;
  }

  Outcome take_message(std::string_view content) {
    ByteReader bytes(content);
    const auto number = bytes.number<std::uint16_t>();
    bytes.number<std::uint32_t>();  // its place in the channel
    const auto t_ns = bytes.number<std::uint64_t>();
    bytes.number<std::uint64_t>();  // when it was published
    if (!bytes.ok()) return wrong("the message ends within its head");
    const auto found = channels_.find(number);
    if (found == channels_.end())
      return wrong(fmt::format("found a message of channel {}; expected one that the file has before it", number));
    if (!found->second.wanted) return std::nullopt;
    return placed(use_.message({found->second.channel, t_ns, bytes.view(bytes.left())}));
  }

  Outcome take_metadata(std::string_view content) {
    ByteReader bytes(content);
    const auto name = std::string(bytes.text());
    ByteReader list(bytes.text());
    McapEntries entries;
    while (list.ok() && list.left() > 0) {
      auto& [key, value] = entries.emplace_back();
      key = list.text();
      value = list.text();
    }
    if (!bytes.ok() || !list.ok()) return wrong("the metadata end within their members");
    return placed(use_.metadata(name, entries));
  }

  Outcome placed(Outcome problem) const {
    return problem ? wrong(problem->where.empty() ? problem->sentence : problem->text()) : problem;
  }

  struct Channel {
    McapChannel channel;
    bool wanted = false;
  };

  std::istream& in_;
  const std::string& name_;
  const McapUse& use_;
  std::uint64_t size_ = 0, at_ = 0, chunk_at_ = 0;  // of the file; the record's beginning, in its chunk if it is in one
  std::uint64_t length_ = 0;                        // of the record's content
  bool in_chunk_ = false, done_ = false;
  std::map<std::uint16_t, McapSchema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
};

}  // namespace

bool is_mcap_file(const std::string& path) {
  if (folded(path).ends_with(".mcap")) return true;
  std::ifstream file(path, std::ios::binary);
  std::string begin(mcap_magic.size(), '\0');
  return file.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == mcap_magic;
}

Outcome read_mcap(std::istream& in, const std::string& name, const McapUse& use) {
  return McapReading(in, name, use).read();
}

}  // namespace continua
