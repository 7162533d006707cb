#include "continua/core/gzip_pieces.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <deque>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "continua/core/gzip_blocks.h"
#include "continua/core/gzip_text.h"

namespace continua {
namespace {

constexpr int window_and_header = 15 + 16;  // zlib: a window of 15 bits, plus 16 for the gzip header
constexpr std::size_t read_bytes = std::size_t{1} << 16, piece_bytes = std::size_t{1} << 20;

// Packed JSON lines become 5 to 30 times as long. A text that becomes much longer was made to fill a memory.
constexpr std::uint64_t most_times = 200, never_too_long = std::uint64_t{64} << 20;

constexpr int damaged = EBADMSG, cut = ENODATA, too_long = EFBIG;  // errno

bool is_too_long(std::uint64_t text, std::uint64_t packed) {
  return text > never_too_long && text / most_times > packed;
}

std::size_t read_at(std::istream& packed, std::uint64_t offset, char* into, std::size_t size) {
  packed.clear();
  packed.seekg(static_cast<std::streamoff>(offset));
  packed.read(into, static_cast<std::streamsize>(size));
  return static_cast<std::size_t>(packed.gcount());
}

// The rest of a text's room.
struct Room {
  explicit Room(std::string& text) : next(text.data()), bytes(text.size()) {}
  char* next;
  std::size_t bytes;
};

// zlib in the midst of its work. A copy goes on from the same place.
class Inflater {
 public:
  Inflater() { require(inflateInit2(&stream_, window_and_header) == Z_OK, "memory for zlib"); }
  Inflater(const Inflater& other) {
    require(inflateCopy(&stream_, const_cast<z_stream*>(&other.stream_)) == Z_OK, "memory for zlib");
  }
  Inflater& operator=(const Inflater&) = delete;
  ~Inflater() { inflateEnd(&stream_); }

  /// Takes bytes from the beginning of `from`. Gives zlib's state.
  int go_on(std::string_view& from, Room& room) {
    stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(from.data()));
    stream_.avail_in = static_cast<uInt>(from.size());
    stream_.next_out = reinterpret_cast<Bytef*>(room.next);
    stream_.avail_out = static_cast<uInt>(room.bytes);
    const int state = inflate(&stream_, Z_NO_FLUSH);
    from.remove_prefix(from.size() - stream_.avail_in);
    room.next += room.bytes - stream_.avail_out;
    room.bytes = stream_.avail_out;
    return state;
  }
  /// Whether it is between two members of a file, or before the first.
  bool is_between() const { return stream_.total_in == 0; }
  void begin_next() { inflateReset(&stream_); }

 private:
  z_stream stream_{};
};

class Blocks : public GzipPieces {
 public:
  explicit Blocks(std::unique_ptr<std::istream> packed) : packed_(std::move(packed)) {}

  /// Whether all of it is in blocks, as far as their lengths tell. Nothing is unpacked yet.
  bool find() {
    std::array<char, block_head_bytes> head{};
    std::array<char, block_tail_bytes> tail{};
    for (;;) {
      const auto got = read_at(*packed_, packed_bytes_, head.data(), head.size());
      if (got == 0) return packed_bytes_ > 0;
      const auto bytes = block_bytes_of({head.data(), got});
      if (!bytes) return false;
      const auto end = packed_bytes_ + *bytes;
      if (read_at(*packed_, end - tail.size(), tail.data(), tail.size()) < tail.size()) return false;
      const auto text = text_bytes_of({tail.data(), tail.size()});
      if (text > read_bytes) return false;
      if (text > 0) blocks_.push_back({packed_bytes_, text_bytes_, *bytes, text});
      packed_bytes_ = end;
      text_bytes_ += text;
      ends_ = text == 0;
    }
  }
  /// The errno of what is wrong with all of it, or 0.
  int problem() const { return !ends_ ? cut : is_too_long(text_bytes_, packed_bytes_) ? too_long : 0; }
  std::unique_ptr<std::istream> release() { return std::move(packed_); }

  std::optional<GzipPiece> at(std::uint64_t offset) override {
    if (offset >= text_bytes_) return GzipPiece{offset, ""};
    const auto after = std::upper_bound(blocks_.begin(), blocks_.end(), offset,
                                        [](std::uint64_t at, const Block& one) { return at < one.text_at; });
    const auto& block = *std::prev(after);
    std::string packed(block.packed, '\0');
    GzipPiece piece{block.text_at, std::string(block.text, '\0')};
    std::string_view from = packed;
    Room room(piece.text);
    if (read_at(*packed_, block.packed_at, packed.data(), packed.size()) == packed.size() &&
        Inflater().go_on(from, room) == Z_STREAM_END && room.bytes == 0 && from.empty())
      return piece;
    errno = damaged;
    return std::nullopt;
  }

 private:
  struct Block {
    std::uint64_t packed_at, text_at;
    std::uint32_t packed, text;  // bytes
  };
  std::unique_ptr<std::istream> packed_;
  std::vector<Block> blocks_;  // those with a text
  std::uint64_t packed_bytes_ = 0, text_bytes_ = 0;
  bool ends_ = false;
};

// Unpacked from the beginning, as far as somebody asks. For each piece of that, the place where zlib can go on.
class InOne : public GzipPieces {
 public:
  explicit InOne(std::unique_ptr<std::istream> packed) : packed_(std::move(packed)) { begins_.emplace_back(); }

  std::optional<GzipPiece> at(std::uint64_t offset) override {
    const auto wanted = static_cast<std::size_t>(offset / piece_bytes);
    for (auto number = std::min(wanted, begins_.size() - 1);; ++number) {
      auto piece = unpacked(number);
      if (!piece || number == wanted) return piece;
      if (number + 1 == begins_.size()) return GzipPiece{offset, ""};
    }
  }

 private:
  struct Begin {
    std::uint64_t packed_at = 0;
    Inflater inflater = {};
  };

  std::optional<GzipPiece> unpacked(std::size_t number) {
    GzipPiece piece{number * piece_bytes, std::string(piece_bytes, '\0')};
    Begin place = begins_[number];
    Room room(piece.text);
    if (const int problem = go_on(place, room, piece.offset)) {
      errno = problem;
      return std::nullopt;
    }
    piece.text.resize(piece.text.size() - room.bytes);
    if (room.bytes == 0 && number + 1 == begins_.size()) begins_.push_back(place);
    return piece;
  }

  // Until there is no more room, or nothing more. Gives the errno of a problem.
  int go_on(Begin& place, Room& room, std::uint64_t text_at) {
    const auto* first = room.next;
    std::array<char, read_bytes> bytes;
    std::string_view from;  // what is left of them
    while (room.bytes > 0) {
      if (from.empty()) from = {bytes.data(), read_at(*packed_, place.packed_at, bytes.data(), bytes.size())};
      const auto left = from.size();
      if (left == 0 && place.inflater.is_between()) return 0;
      const int state = place.inflater.go_on(from, room);
      place.packed_at += left - from.size();
      if (state == Z_BUF_ERROR && left == 0) return cut;
      if (state == Z_STREAM_END)
        place.inflater.begin_next();
      else if (state != Z_OK && state != Z_BUF_ERROR)
        return damaged;
      if (is_too_long(text_at + static_cast<std::uint64_t>(room.next - first), place.packed_at)) return too_long;
    }
    return 0;
  }

  std::unique_ptr<std::istream> packed_;
  std::deque<Begin> begins_;  // of the pieces
};

}  // namespace

Result<std::unique_ptr<GzipPieces>> GzipPieces::of(std::unique_ptr<std::istream> packed, const std::string& name) {
  auto blocks = std::make_unique<Blocks>(std::move(packed));
  if (!blocks->find()) return std::unique_ptr<GzipPieces>(std::make_unique<InOne>(blocks->release()));
  if (const int problem = blocks->problem()) return Error{name, unpacking_problem(problem)};
  return std::unique_ptr<GzipPieces>(std::move(blocks));
}

std::string unpacking_problem(int error) {
  if (error == cut) return "is cut short: its packed bytes end in the midst; expected a whole gzip file";
  if (error == damaged) return "is damaged: its packed bytes cannot be unpacked here; expected a whole gzip file";
  if (error != too_long) return "";
  return fmt::format("becomes more than {} times as long when it is unpacked; expected at most so much", most_times);
}

}  // namespace continua
