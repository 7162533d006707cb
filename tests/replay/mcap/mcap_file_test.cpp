// MCAP files: written and read, whole and broken.
#include <rapidcheck.h>
#include <sstream>

#include "continua/replay/mcap/chunk_packing.h"
#include "continua/replay/mcap/little_endian.h"
#include "continua/replay/mcap/mcap_reader.h"
#include "continua/replay/mcap/mcap_writer.h"
#include "support/catch.h"

namespace continua {
namespace {

struct Told {
  std::string topic, data;
  std::uint64_t t_ns = 0;
  friend bool operator==(const Told&, const Told&) = default;
};

struct ReadFile {
  std::vector<Told> messages;
  McapEntries metadata;
  Outcome problem;
};

ReadFile read(const std::string& bytes, const std::string& only_topic = "") {
  std::istringstream in(bytes);
  ReadFile read;
  read.problem =
      read_mcap(in, "t.mcap",
                {[&](const McapChannel& channel) { return only_topic.empty() || channel.topic == only_topic; },
                 [&](const McapMessage& message) {
                   read.messages.push_back({message.channel.topic, std::string(message.data), message.t_ns});
                   return Outcome();
                 },
                 [&](const std::string&, const McapEntries& entries) {
                   read.metadata = entries;
                   return Outcome();
                 }});
  return read;
}

std::string written(const std::vector<Told>& messages) {
  std::ostringstream out;
  McapWriter mcap(out, "", "test");
  mcap.metadata("m", {{"key", "value"}});
  for (const auto& message : messages)
    mcap.message(mcap.channel({message.topic, "json", {"schema of " + message.topic, "jsonschema", "{}"}}),
                 message.t_ns, message.data);
  mcap.attach("a.txt", "text/plain", "attached");
  mcap.finish();
  return out.str();
}

// A record as a file has it.
std::string record(int op, const std::string& content) {
  std::string bytes(1, static_cast<char>(op));
  put_number(bytes, static_cast<std::uint64_t>(content.size()));
  return bytes + content;
}

std::string file_of(const std::string& records) { return std::string(mcap_magic) + records; }

std::string chunk_of(const std::string& records, const std::string& compression, std::uint64_t size,
                     std::uint32_t crc) {
  std::string content(16, '\0');
  put_number(content, size);
  put_number(content, crc);
  put_text(content, compression);
  put_number(content, static_cast<std::uint64_t>(records.size()));
  return record(6, content + records);
}

TEST_CASE("Messages come back as they were written") {
  const auto law = [](const std::vector<std::tuple<bool, std::string, std::uint32_t>>& all) {
    std::vector<Told> messages;
    for (const auto& [first, data, t_ns] : all) messages.push_back({first ? "/a" : "/b", data, t_ns});
    const auto back = read(written(messages));
    RC_ASSERT_FALSE(back.problem.has_value());
    RC_ASSERT(back.messages == messages);
    RC_ASSERT(back.metadata == (McapEntries{{"key", "value"}}));
  };
  CHECK(rc::check(law));
}

TEST_CASE("Messages fill as many chunks as they need") {
  std::vector<Told> messages;
  for (std::uint64_t i = 0; i < 3000; ++i) messages.push_back({"/a", std::string(1000, char('a' + i % 26)), i});
  const auto bytes = written(messages);
  CHECK(bytes.size() < 100000);
  CHECK(read(bytes).messages == messages);
}

TEST_CASE("Only the messages that are wanted are told") {
  const auto back = read(written({{"/a", "1", 0}, {"/b", "2", 1}}), "/b");
  CHECK(back.messages == std::vector<Told>{{"/b", "2", 1}});
}

TEST_CASE("A file cut anywhere before the end of its data is an error with a byte") {
  const auto bytes = written({{"/a", "1", 0}, {"/b", "2", 1}});
  const auto end = bytes.find(record(15, std::string(4, '\0')));
  REQUIRE(end != std::string::npos);
  for (std::size_t size = 0; size < end; ++size) {
    const auto problem = read(bytes.substr(0, size)).problem;
    INFO(size);
    REQUIRE(problem);
    CHECK(problem->where.starts_with("t.mcap: byte "));
  }
}

TEST_CASE("A changed byte is an error, or changes nothing of the messages but what no checksum covers") {
  const auto bytes = written({{"/a", "{\"x\":1}", 0}, {"/b", "{\"x\":2}", 1}});
  for (std::size_t at = 0; at < bytes.size(); ++at)
    for (const unsigned change : {0x01U, 0x80U, 0xffU}) {
      auto broken = bytes;
      broken[at] = static_cast<char>(static_cast<unsigned char>(broken[at]) ^ change);
      const auto back = read(broken);
      INFO(at);
      if (!back.problem) CHECK(back.messages.size() <= 2);
    }
}

TEST_CASE("Broken files are errors that name the place, the found and the expected") {
  std::string channel;
  put_number(channel, std::uint16_t{1});
  put_number(channel, std::uint16_t{7});
  put_text(channel, "/a");
  put_text(channel, "json");
  put_text(channel, "");
  const auto message = std::string(22, '\1');
  const std::string long_head = "\6" + std::string(8, '\x7f');
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"PNG", "t.mcap: byte 0: found other bytes; expected those with which MCAP 0 begins"},
      {file_of(""),
       "t.mcap: byte 8: the file ends here; expected more records, then the end of the data: it is cut short"},
      {file_of("\1\0"), "t.mcap: byte 8: the file ends within a record: it is cut short"},
      {file_of(long_head),
       "t.mcap: byte 8: found a record of 9187201950435737471 bytes; expected at most the 0 that are "
       "left: the file is damaged or cut short"},
      {file_of(record(4, channel)),
       "t.mcap: byte 8: found a channel with the schema 7; expected one that the file has before it"},
      {file_of(record(4, "\1")), "t.mcap: byte 8: the channel ends within its members"},
      {file_of(record(3, "\1")), "t.mcap: byte 8: the schema ends within its members"},
      {file_of(record(12, "\1")), "t.mcap: byte 8: the metadata end within their members"},
      {file_of(record(5, message)),
       "t.mcap: byte 8: found a message of channel 257; expected one that the file has before it"},
      {file_of(record(5, "\1")), "t.mcap: byte 8: the message ends within its head"},
      {file_of(record(6, "\1")), "t.mcap: byte 8: the chunk ends within its members"},
      {file_of(chunk_of("x", "lz4", 1, 0)),
       "t.mcap: byte 8: found a chunk compressed with 'lz4'; expected 'zstd', or none"},
      {file_of(chunk_of("x", "zstd", 1, 0)), "t.mcap: byte 8: the chunk cannot be unpacked to its 1 bytes"},
      {file_of(chunk_of("x", "", std::uint64_t{1} << 40, 0)),
       "t.mcap: byte 8: found a chunk of 1099511627776 bytes; expected at most 268435456"},
      {file_of(chunk_of("x", "", 1, 5)), "t.mcap: byte 8: the chunk's checksum is another one: it is damaged"},
      {file_of(chunk_of("x", "", 1, 0)), "t.mcap: byte 0 of the chunk at byte 8: the record is longer than its chunk"},
      {file_of(chunk_of(record(99, "") + record(5, message), "", 40, 0)),
       "t.mcap: byte 9 of the chunk at byte 8: found a message of channel 257; expected one that the file has before "
       "it"},
  };
  for (const auto& [bytes, expected] : cases) {
    const auto problem = read(bytes).problem;
    REQUIRE(problem);
    CHECK(problem->text() == expected);
  }
}

TEST_CASE("Unpacking ends at the size that was told") {
  const std::string zeros(1 << 20, '\0');
  const auto packed = zstd_packed(zeros);
  CHECK(zstd_unpacked(packed, zeros.size()) == zeros);
  CHECK_FALSE(zstd_unpacked(packed, 1000));
  CHECK_FALSE(zstd_unpacked(packed, zeros.size() + 1));
  CHECK_FALSE(zstd_unpacked(packed.substr(0, packed.size() - 1), zeros.size()));
  CHECK(zstd_unpacked(packed + packed, 2 * zeros.size()) == zeros + zeros);
  CHECK(crc32_of("123456789") == 0xcbf43926);
}

}  // namespace
}  // namespace continua
