#include "continua/replay/log/log_file.h"

#include <optional>
#include <utility>

#include "continua/replay/log/kept_documents.h"

namespace continua {
namespace {

constexpr std::size_t longest_header = std::size_t{64} << 20;
constexpr std::size_t first_piece = std::size_t{1} << 16;
constexpr auto wanted = "cannot be read; expected a run log";

// A log whose first line stands for a longer one.
class WithDocuments : public LogSource {
 public:
  /// `header`: the longer line, which takes the place of as many bytes of the log.
  WithDocuments(std::string header, std::shared_ptr<const LogSource> log, std::uint64_t instead_of)
      : header_(std::move(header)), log_(std::move(log)), instead_of_(instead_of) {}

  ssize_t read(std::uint64_t offset, char* into, std::size_t size) const override {
    std::size_t done = 0;
    if (offset < header_.size()) done = header_.copy(into, size, offset);
    if (done == size) return static_cast<ssize_t>(done);
    const auto rest = log_->read(offset + done - header_.size() + instead_of_, into + done, size - done);
    return rest < 0 ? rest : static_cast<ssize_t>(done) + rest;
  }

 private:
  std::string header_;
  std::shared_ptr<const LogSource> log_;
  std::uint64_t instead_of_;
};

// Without its end. Nothing if it cannot be read.
std::optional<std::string> first_line(const LogSource& source) {
  std::string line;
  for (std::size_t size = first_piece; line.size() < longest_header; size *= 2) {
    const auto from = line.size();
    line.resize(from + size);
    const auto got = source.read(from, line.data() + from, size);
    if (got < 0) return std::nullopt;
    line.resize(from + static_cast<std::size_t>(got));
    if (const auto end = line.find('\n', from); end != line.npos) return line.substr(0, end);
    if (static_cast<std::size_t>(got) < size) break;
  }
  return line;
}

}  // namespace

Result<std::shared_ptr<const LogSource>> source_of_log(const std::string& path) {
  auto file = source_of_file(path);
  const auto header = file ? first_line(*file) : std::nullopt;
  if (!header) return Error{path, wanted};
  auto whole = with_documents(*header, path);
  if (!whole) return whole.error();
  if (*whole != *header) file = std::make_shared<const WithDocuments>(*std::move(whole), file, header->size());
  return file;
}

bool read_pieces(const LogSource& source, const std::function<void(std::string_view)>& use) {
  std::string piece(block_bytes, '\0');
  for (std::uint64_t offset = 0;;) {
    const auto got = source.read(offset, piece.data(), piece.size());
    if (got < 0) return false;
    if (got == 0) return true;
    use(std::string_view(piece).substr(0, static_cast<std::size_t>(got)));
    offset += static_cast<std::uint64_t>(got);
  }
}

Result<std::string> read_run_log(const std::string& path) {
  const auto source = source_of_log(path);
  if (!source) return source.error();
  std::string text;
  if (!read_pieces(**source, [&](std::string_view piece) { text.append(piece); })) return Error{path, wanted};
  return text;
}

Result<std::string> first_line(const std::string& path) {
  const auto file = source_of_file(path);
  auto line = file ? first_line(*file) : std::nullopt;
  if (!line) return Error{path, wanted};
  return *std::move(line);
}

bool is_run_log_name(std::string_view path) { return path.ends_with(".jsonl"); }

}  // namespace continua
