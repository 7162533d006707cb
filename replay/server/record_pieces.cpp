#include "continua/replay/server/record_pieces.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <iterator>

#include <fmt/format.h>

namespace continua {
namespace {

constexpr std::uint64_t most_bytes = 1 << 20;  // of a piece, unless a line is longer

}  // namespace

std::string chunk_of(std::string_view text) { return fmt::format("{:x}\r\n{}\r\n", text.size(), text); }

std::string event_text(std::string_view name, std::string_view data) {
  return fmt::format("event: {}\ndata: {}\n\n", name, data);
}

RecordPieces::RecordPieces(const std::string& log_path) : file_(::open(log_path.c_str(), O_RDONLY | O_CLOEXEC)) {}

RecordPieces::~RecordPieces() {
  if (file_ >= 0) ::close(file_);
}

// The whole lines between two places.
std::string RecordPieces::lines(std::uint64_t begin, std::uint64_t end) const {
  std::string text(end - begin, '\0');
  std::size_t read = 0;
  while (read < text.size()) {
    const auto got = ::pread(file_, text.data() + read, text.size() - read, static_cast<off_t>(begin + read));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) break;
    read += static_cast<std::size_t>(got);
  }
  text.resize(read);
  text.resize(text.rfind('\n') + 1);
  return text;
}

std::shared_ptr<const RecordPiece> RecordPieces::at(const LogPlace& begin, std::uint64_t bytes, std::uint64_t from) {
  if (last_ && last_->begin == begin && last_->end.bytes <= bytes &&
      (last_->from == from || std::max(last_->from, from) <= begin.record))
    return last_;
  std::string text;
  for (auto most = most_bytes; text.empty(); most *= 2) {
    text = lines(begin.bytes, std::min(bytes, begin.bytes + most));
    if (text.empty() && begin.bytes + most >= bytes) return nullptr;
  }
  RecordPiece piece{begin, {begin.bytes + text.size(), begin.record}, from, nullptr};
  std::string events;
  for (std::string_view left = text; !left.empty(); ++piece.end.record) {
    const auto line = left.substr(0, left.find('\n'));
    left.remove_prefix(line.size() + 1);
    if (piece.end.record >= from)
      fmt::format_to(std::back_inserter(events), "id: {}\nevent: record\ndata: {}\n\n", piece.end.record, line);
  }
  if (!events.empty()) piece.chunk = std::make_shared<const std::string>(chunk_of(events));
  return last_ = std::make_shared<const RecordPiece>(std::move(piece));
}

}  // namespace continua
