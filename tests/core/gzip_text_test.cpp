// Texts packed in blocks, and any other gzip file, read at any place.
#include "continua/core/gzip_text.h"

#include <cerrno>
#include <fstream>
#include <map>
#include <sstream>

#include "continua/core/gzip.h"
#include "continua/core/gzip_blocks.h"
#include "continua/core/located_json.h"
#include "continua/core/replaced_file.h"
#include "support/catch.h"
#include "support/temporary_folder.h"

#include <rapidcheck.h>

using namespace continua;

namespace {

std::string in_blocks(std::string_view text, std::size_t part = 1000) {
  GzipBlocks blocks;
  std::string packed;
  for (; !text.empty(); text.remove_prefix(std::min(part, text.size()))) packed += blocks.add(text.substr(0, part));
  return packed + blocks.finish();
}

Result<std::shared_ptr<const GzipText>> opened(const std::string& packed) {
  return GzipText::of(std::make_unique<std::istringstream>(packed), "a.gz");
}

// The text, or what is wrong.
std::string told(const std::string& packed) {
  const auto text = opened(packed);
  if (!text) return text.error().text();
  std::string all;
  const auto problem = (*text)->read_all([&](std::string_view part) { all += part; });
  return problem ? problem->text() : all;
}

std::string lines(std::size_t bytes, unsigned seed = 1) {
  std::string text;
  for (std::size_t n = 0; text.size() < bytes; ++n, seed = seed * 1664525U + 1013904223U)
    text += R"({"kind":"pose","n":)" + std::to_string(n) + R"(,"x":)" + std::to_string(seed) +
            std::string(seed >> 24U, '.') + "}\n";
  return text;
}

std::string part_of(const GzipText& text, std::uint64_t offset, std::size_t size) {
  std::string part(size, '?');
  const auto got = text.read(offset, part.data(), part.size());
  RC_ASSERT(got >= 0);
  part.resize(static_cast<std::size_t>(got));
  return part;
}

// The ways in which a text may be packed.
const std::map<std::string, std::string (*)(const std::string&)> ways{
    {"in blocks", [](const std::string& text) { return in_blocks(text); }},
    {"in one", [](const std::string& text) { return gzipped(text); }},
    {"in two",
     [](const std::string& text) {
       return gzipped(text.substr(0, text.size() / 2)) + gzipped(text.substr(text.size() / 2));
     }},
    {"in blocks, then in one", [](const std::string& text) {
       return in_blocks(text.substr(0, text.size() / 2)) + gzipped(text.substr(text.size() / 2));
     }}};

}  // namespace

TEST_CASE("a packed text is the text again, and at each place the same as there") {
  for (const auto& [name, pack] : ways) {
    INFO(name);
    CHECK(told(pack("")).empty());
    CHECK(told(pack("one line\n")) == "one line\n");
    const auto text = lines(12 << 20);  // more pieces than are held
    const auto packed = pack(text);
    CHECK(packed.size() * 3 < text.size());
    CHECK(told(packed) == text);
    const auto read = opened(packed);
    REQUIRE(read.ok());
    CHECK(rc::check("random access is sequential access", [&, &pack = read.value()] {
      const auto offset = *rc::gen::inRange<std::size_t>(0, text.size() + 100);
      const auto size = *rc::gen::inRange<std::size_t>(0, 200000);
      RC_ASSERT(part_of(*pack, offset, size) == (offset < text.size() ? text.substr(offset, size) : ""));
    }));
  }
}

TEST_CASE("random texts come back from blocks, whatever the parts in which they came") {
  CHECK(rc::check([] {
    std::string text;
    for (const auto& [times, line] : *rc::gen::container<std::vector<std::pair<unsigned, std::string>>>(
             rc::gen::pair(rc::gen::inRange(0U, 9000U), rc::gen::string<std::string>())))
      for (unsigned i = 0; i < times; ++i) text += line + (times % 3 == 0 ? "" : "\n");
    const auto packed = in_blocks(text, *rc::gen::inRange<std::size_t>(1, 100000));
    RC_ASSERT(packed == in_blocks(text, 1 << 20));
    RC_ASSERT(told(packed) == text);
  }));
}

TEST_CASE("a block ends with a line, has no time in it, and is as long as it says") {
  const auto text = lines(1 << 20) + std::string(200000, 'x') + "\n" + lines(1000);
  const auto packed = in_blocks(text);
  std::size_t blocks = 0, text_at = 0, split = 0;
  for (std::size_t at = 0; at < packed.size(); ++blocks) {
    const auto bytes = block_bytes_of(std::string_view(packed).substr(at));
    REQUIRE(bytes);
    CHECK(packed.substr(at + 4, 4) == std::string(4, '\0'));
    text_at += text_bytes_of(packed.substr(at + *bytes - block_tail_bytes, block_tail_bytes));
    split += text_at > 0 && text[text_at - 1] != '\n';
    at += *bytes;
  }
  CHECK(text_at == text.size());
  CHECK(split == 3);  // in the line that is longer than a block
  CHECK(blocks > 16);
}

TEST_CASE("packed bytes that are cut or damaged are refused anywhere") {
  const auto text = lines(1 << 20);
  for (const auto& [name, pack] : ways) {
    INFO(name);
    const auto packed = pack(text);
    for (std::size_t length = 2; length < packed.size(); length += packed.size() / 40) {
      INFO("cut after " << length);
      CHECK(told(packed.substr(0, length)).starts_with("a.gz: is cut short"));
    }
    CHECK(told(packed.substr(0, packed.size() - 1)).starts_with("a.gz: is cut short"));
    for (std::size_t at = 20; at < packed.size(); at += packed.size() / 50) {
      INFO("another byte at " << at);
      auto wrong = packed;
      wrong[at] = static_cast<char>(wrong[at] ^ 0x55);
      const auto now = told(wrong);
      CHECK((now == text || now.starts_with("a.gz: is damaged") || now.starts_with("a.gz: is cut short")));
    }
    CHECK(told(packed + "more").starts_with("a.gz: is damaged"));
  }
  // A cut between two blocks.
  const auto packed = in_blocks(text);
  const auto first = *block_bytes_of(packed);
  CHECK(told(packed.substr(0, first)).starts_with("a.gz: is cut short"));
}

TEST_CASE("random bytes after a beginning of gzip end with words") {
  CHECK(rc::check([] {
    const auto bytes = *rc::gen::container<std::string>(rc::gen::arbitrary<char>());
    const auto now = told("\x1f\x8b" + bytes);
    RC_ASSERT(now.empty() || now.starts_with("a.gz: is "));
  }));
}

TEST_CASE("a file of very many small members is read, none of them twice") {
  const auto member = gzipped("x\n"), empty = gzipped("");
  std::string packed, text;
  for (int i = 0; i < 200000; ++i) packed += i % 2 ? empty : member, text += i % 2 ? "" : "x\n";
  CHECK(told(packed) == text);
}

TEST_CASE("a text that would fill the memory is refused before it does") {
  const std::string zeros(1 << 20, '\0');
  const auto member = gzipped(zeros, 9);
  std::string in_members;
  for (int i = 0; i < 500; ++i) in_members += member;
  CHECK(told(in_members).starts_with("a.gz: becomes more than 200 times as long"));
  std::string all;
  for (int i = 0; i < 100; ++i) all += zeros;
  CHECK(told(gzipped(all, 9)).starts_with("a.gz: becomes more than 200 times as long"));
  CHECK(told(in_blocks(all, 1 << 20)).starts_with("a.gz: becomes more than 200 times as long"));
}

TEST_CASE("a file is written packed where its name says so, and read by what is in it") {
  const TemporaryFolder folder;
  const auto text = lines(300000);
  for (const auto* name : {"a.jsonl", "a.jsonl.gz"}) CHECK_FALSE(replace_file(folder.at(name), text));
  CHECK(read_file(folder.at("a.jsonl.gz")).value() == in_blocks(text));
  CHECK(is_gzip_file(folder.at("a.jsonl.gz")));
  CHECK_FALSE(is_gzip_file(folder.at("a.jsonl")));
  CHECK_FALSE(is_gzip_file(folder.at("none")));
  for (const auto* name : {"a.jsonl", "a.jsonl.gz"}) CHECK(read_text(folder.at(name)).value() == text);
  const auto plain = folder.file("b.gz", "no gzip");
  CHECK(read_text(plain).value() == "no gzip");

  const auto packed = GzipText::open(folder.at("a.jsonl.gz"));
  REQUIRE(packed.ok());
  const auto stream = stream_of(*packed);
  CHECK(std::string(std::istreambuf_iterator<char>(*stream), {}) == text);
}
