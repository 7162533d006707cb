#include "continua/core/gzip_text.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <list>
#include <mutex>
#include <sstream>
#include <streambuf>

#include "continua/core/gzip_pieces.h"
#include "continua/core/located_json.h"

namespace continua {
namespace {

constexpr std::string_view magic = "\x1f\x8b";
constexpr std::size_t most_held = 8;  // pieces
constexpr std::size_t part_bytes = std::size_t{1} << 16;

// Reads a packed text from its beginning.
class Streamed : public std::streambuf {
 public:
  explicit Streamed(std::shared_ptr<const GzipText> text) : text_(std::move(text)) {}

 protected:
  int_type underflow() override {
    const auto got = text_->read(read_, part_.data(), part_.size());
    if (got <= 0) return traits_type::eof();
    read_ += static_cast<std::uint64_t>(got);
    setg(part_.data(), part_.data(), part_.data() + got);
    return traits_type::to_int_type(part_.front());
  }

 private:
  const std::shared_ptr<const GzipText> text_;
  std::uint64_t read_ = 0;
  std::array<char, part_bytes> part_;
};

class Stream : public std::istream {
 public:
  explicit Stream(std::shared_ptr<const GzipText> text) : std::istream(nullptr), buffer_(std::move(text)) {
    rdbuf(&buffer_);
  }

 private:
  Streamed buffer_;
};

}  // namespace

// The pieces used last, the last one first.
class GzipText::Held {
 public:
  explicit Held(std::unique_ptr<GzipPieces> pieces) : pieces_(std::move(pieces)) {}

  ssize_t read(std::uint64_t offset, char* into, std::size_t size) {
    const std::lock_guard lock(mutex_);
    std::size_t done = 0;
    while (done < size) {
      const auto* piece = at(offset + done);
      if (!piece) return -1;
      const auto from = static_cast<std::size_t>(offset + done - piece->offset);
      if (from >= piece->text.size()) break;
      done += piece->text.copy(into + done, size - done, from);
    }
    return static_cast<ssize_t>(done);
  }

 private:
  const GzipPiece* at(std::uint64_t offset) {
    const auto held = std::find_if(held_.begin(), held_.end(), [&](const GzipPiece& one) {
      return offset >= one.offset && offset - one.offset < one.text.size();
    });
    if (held == held_.end()) {
      auto piece = pieces_->at(offset);
      if (!piece) return nullptr;
      if (held_.size() == most_held) held_.pop_back();
      return &held_.emplace_front(*std::move(piece));
    }
    held_.splice(held_.begin(), held_, held);
    return &held_.front();
  }

  std::mutex mutex_;  // guards the others
  std::unique_ptr<GzipPieces> pieces_;
  std::list<GzipPiece> held_;
};

bool begins_as_gzip(std::string_view bytes) { return bytes.starts_with(magic); }

bool is_gzip_file(const std::string& path) {
  std::error_code unknown;
  if (!std::filesystem::is_regular_file(path, unknown)) return false;
  std::ifstream file(path, std::ios::binary);
  std::array<char, magic.size()> bytes{};
  return file.read(bytes.data(), bytes.size()) && begins_as_gzip({bytes.data(), bytes.size()});
}

Result<std::shared_ptr<const GzipText>> GzipText::open(const std::string& path) {
  auto file = std::make_unique<std::ifstream>(path, std::ios::binary);
  if (!*file) return Error{path, "cannot be opened; expected a readable file"};
  return of(std::move(file), path);
}

Result<std::shared_ptr<const GzipText>> GzipText::of(std::unique_ptr<std::istream> packed, const std::string& name) {
  auto pieces = GzipPieces::of(std::move(packed), name);
  if (!pieces) return pieces.error();
  return std::shared_ptr<const GzipText>(new GzipText(std::make_unique<Held>(*std::move(pieces)), name));
}

GzipText::GzipText(std::unique_ptr<Held> held, std::string name) : held_(std::move(held)), name_(std::move(name)) {}
GzipText::~GzipText() = default;

ssize_t GzipText::read(std::uint64_t offset, char* into, std::size_t size) const {
  return held_->read(offset, into, size);
}

Outcome GzipText::read_all(const std::function<void(std::string_view)>& use) const {
  std::string part(part_bytes, '\0');
  for (std::uint64_t offset = 0;;) {
    const auto got = read(offset, part.data(), part.size());
    if (got < 0) return Error{name_, unpacking_problem(errno)};
    if (got == 0) return std::nullopt;
    use(std::string_view(part).substr(0, static_cast<std::size_t>(got)));
    offset += static_cast<std::uint64_t>(got);
  }
}

Result<std::string> read_text(const std::string& path) {
  auto bytes = read_file(path);
  if (!bytes || !begins_as_gzip(*bytes)) return bytes;
  const auto packed = GzipText::of(std::make_unique<std::istringstream>(*std::move(bytes)), path);
  if (!packed) return packed.error();
  std::string text;
  if (auto problem = (*packed)->read_all([&](std::string_view part) { text.append(part); })) return *std::move(problem);
  return text;
}

std::unique_ptr<std::istream> stream_of(std::shared_ptr<const GzipText> text) {
  return std::make_unique<Stream>(std::move(text));
}

}  // namespace continua
