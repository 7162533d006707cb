#include "continua/replay/mcap/mcap_writer.h"

#include <algorithm>

#include "continua/replay/mcap/chunk_packing.h"
#include "continua/replay/mcap/little_endian.h"

namespace continua {
namespace {

// Readers hold a chunk in memory; larger ones compress hardly better.
constexpr std::size_t full_chunk = std::size_t{1} << 20;

std::string record(McapOp op, std::string_view content) {
  std::string bytes;
  put_number(bytes, op_number(op));
  put_number(bytes, static_cast<std::uint64_t>(content.size()));
  return bytes += content;
}

void put_entries(std::string& bytes, const McapEntries& entries) {
  std::string list;
  for (const auto& [name, value] : entries) {
    put_text(list, name);
    put_text(list, value);
  }
  put_text(bytes, list);
}

}  // namespace

void McapWriter::Span::add(std::uint64_t t_ns) {
  from_ns = any ? std::min(from_ns, t_ns) : t_ns;
  to_ns = any ? std::max(to_ns, t_ns) : t_ns;
  any = true;
}

McapWriter::McapWriter(std::ostream& out, std::string_view profile, std::string_view library) : out_(out) {
  put(mcap_magic);
  std::string header;
  put_text(header, profile);
  put_text(header, library);
  put_record(McapOp::header, header);
}

void McapWriter::put(std::string_view bytes) {
  out_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  at_ += bytes.size();
}

void McapWriter::put_record(McapOp op, std::string_view content) { put(record(op, content)); }

std::uint16_t McapWriter::channel(const McapChannel& channel) {
  const auto next_schema = static_cast<std::uint16_t>(schemas_.size() + 1);
  const auto [schema, fresh_schema] = schema_numbers_.emplace(channel.schema.name, next_schema);
  if (fresh_schema) {
    std::string content;
    put_number(content, schema->second);
    for (const auto& text : {channel.schema.name, channel.schema.encoding, channel.schema.data})
      put_text(content, text);
    schemas_.push_back(record(McapOp::schema, content));
    chunk_ += schemas_.back();
  }
  const auto next_channel = static_cast<std::uint16_t>(channels_.size() + 1);
  const auto [number, fresh] = channel_numbers_.emplace(channel.topic, next_channel);
  if (fresh) {
    std::string content;
    put_number(content, number->second);
    put_number(content, schema->second);
    put_text(content, channel.topic);
    put_text(content, channel.message_encoding);
    put_entries(content, {});
    channels_.push_back(record(McapOp::channel, content));
    chunk_ += channels_.back();
  }
  return number->second;
}

void McapWriter::message(std::uint16_t channel, std::uint64_t t_ns, std::string_view data) {
  auto& index = indexes_[channel];
  put_number(index, t_ns);
  put_number(index, static_cast<std::uint64_t>(chunk_.size()));
  std::string content;
  put_number(content, channel);
  put_number(content, counts_[channel]++);
  put_number(content, t_ns);  // logged
  put_number(content, t_ns);  // published
  content += data;
  chunk_ += record(McapOp::message, content);
  chunk_span_.add(t_ns);
  span_.add(t_ns);
  if (chunk_.size() >= full_chunk) finish_chunk();
}

void McapWriter::finish_chunk() {
  if (chunk_.empty()) return;
  const auto packed = zstd_packed(chunk_);
  const auto begin = at_;
  std::string content;
  put_number(content, chunk_span_.from_ns);
  put_number(content, chunk_span_.to_ns);
  put_number(content, static_cast<std::uint64_t>(chunk_.size()));
  put_number(content, crc32_of(chunk_));
  put_text(content, "zstd");
  put_number(content, static_cast<std::uint64_t>(packed.size()));
  content += packed;
  put_record(McapOp::chunk, content);
  const auto end = at_;
  std::string places;
  for (const auto& [channel, index] : indexes_) {
    put_number(places, channel);
    put_number(places, at_);
    std::string list;
    put_number(list, channel);
    put_text(list, index);
    put_record(McapOp::message_index, list);
  }
  auto& chunk_index = chunk_indexes_.emplace_back();
  put_number(chunk_index, chunk_span_.from_ns);
  put_number(chunk_index, chunk_span_.to_ns);
  put_number(chunk_index, begin);
  put_number(chunk_index, end - begin);
  put_text(chunk_index, places);
  put_number(chunk_index, at_ - end);
  put_text(chunk_index, "zstd");
  put_number(chunk_index, static_cast<std::uint64_t>(packed.size()));
  put_number(chunk_index, static_cast<std::uint64_t>(chunk_.size()));
  chunk_index = record(McapOp::chunk_index, chunk_index);
  chunk_.clear();
  indexes_.clear();
  chunk_span_ = {};
}

void McapWriter::attach(const std::string& name, const std::string& media_type, std::string_view data) {
  finish_chunk();
  const auto begin = at_;
  std::string content;
  put_number(content, std::uint64_t{0});  // logged
  put_number(content, std::uint64_t{0});  // created
  put_text(content, name);
  put_text(content, media_type);
  put_number(content, static_cast<std::uint64_t>(data.size()));
  content += data;
  put_number(content, crc32_of(content));
  put_record(McapOp::attachment, content);
  std::string index;
  put_number(index, begin);
  put_number(index, at_ - begin);
  put_number(index, std::uint64_t{0});
  put_number(index, std::uint64_t{0});
  put_number(index, static_cast<std::uint64_t>(data.size()));
  put_text(index, name);
  put_text(index, media_type);
  attachment_indexes_.push_back(record(McapOp::attachment_index, index));
}

void McapWriter::metadata(const std::string& name, const McapEntries& entries) {
  finish_chunk();
  const auto begin = at_;
  std::string content;
  put_text(content, name);
  put_entries(content, entries);
  put_record(McapOp::metadata, content);
  std::string index;
  put_number(index, begin);
  put_number(index, at_ - begin);
  put_text(index, name);
  metadata_indexes_.push_back(record(McapOp::metadata_index, index));
}

std::string McapWriter::statistics() const {
  std::uint64_t messages = 0;
  std::string counts;
  for (const auto& [channel, count] : counts_) {
    messages += count;
    put_number(counts, channel);
    put_number(counts, std::uint64_t{count});
  }
  std::string content;
  put_number(content, messages);
  put_number(content, static_cast<std::uint16_t>(schemas_.size()));
  for (const auto* list : {&channels_, &attachment_indexes_, &metadata_indexes_, &chunk_indexes_})
    put_number(content, static_cast<std::uint32_t>(list->size()));
  put_number(content, span_.from_ns);
  put_number(content, span_.to_ns);
  put_text(content, counts);
  return record(McapOp::statistics, content);
}

void McapWriter::summary_group(McapOp op, const std::vector<std::string>& records, std::string& summary,
                               std::string& offsets, std::uint64_t begin) const {
  if (records.empty()) return;
  const auto from = summary.size();
  for (const auto& one : records) summary += one;
  std::string content;
  put_number(content, op_number(op));
  put_number(content, begin + from);
  put_number(content, static_cast<std::uint64_t>(summary.size() - from));
  offsets += record(McapOp::summary_offset, content);
}

void McapWriter::finish() {
  finish_chunk();
  std::string end;
  put_number(end, std::uint32_t{0});  // no checksum of all: chunks have their own
  put_record(McapOp::data_end, end);
  const auto begin = at_;
  std::string summary, offsets;
  summary_group(McapOp::schema, schemas_, summary, offsets, begin);
  summary_group(McapOp::channel, channels_, summary, offsets, begin);
  summary_group(McapOp::statistics, {statistics()}, summary, offsets, begin);
  summary_group(McapOp::chunk_index, chunk_indexes_, summary, offsets, begin);
  summary_group(McapOp::attachment_index, attachment_indexes_, summary, offsets, begin);
  summary_group(McapOp::metadata_index, metadata_indexes_, summary, offsets, begin);
  const auto offsets_begin = begin + summary.size();
  summary += offsets;
  std::string footer;
  put_number(footer, begin);
  put_number(footer, offsets_begin);
  auto checked = summary + record(McapOp::footer, footer + std::string(sizeof(std::uint32_t), '\0'));
  checked.resize(checked.size() - sizeof(std::uint32_t));
  put_number(footer, crc32_of(checked));
  put(summary);
  put_record(McapOp::footer, footer);
  put(mcap_magic);
}

}  // namespace continua
