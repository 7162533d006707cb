#include "continua/replay/log/log_file.h"

#include <cerrno>
#include <optional>
#include <utility>

#include "continua/core/gzip_name.h"
#include "continua/core/gzip_text.h"
#include "continua/replay/log/kept_documents.h"

namespace continua {
namespace {

constexpr std::size_t longest_header = std::size_t{64} << 20;
constexpr std::size_t first_piece = std::size_t{1} << 16;
constexpr auto wanted = "cannot be read; expected a run log";

class Packed : public LogSource {
 public:
  explicit Packed(std::shared_ptr<const GzipText> text) : text_(std::move(text)) {}
  ssize_t read(std::uint64_t offset, char* into, std::size_t size) const override {
    return text_->read(offset, into, size);
  }

 private:
  std::shared_ptr<const GzipText> text_;
};

// The file as it stands there, unpacked.
Result<std::shared_ptr<const LogSource>> unpacked_source(const std::string& path) {
  if (is_gzip_file(path)) {
    auto text = GzipText::open(path);
    if (!text) return text.error();
    return std::shared_ptr<const LogSource>(std::make_shared<const Packed>(*std::move(text)));
  }
  auto file = source_of_file(path);
  if (!file) return Error{path, wanted};
  return file;
}

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

// Without its end.
Result<std::string> first_line(const LogSource& source, const std::string& path) {
  std::string line;
  for (std::size_t size = first_piece; line.size() < longest_header; size *= 2) {
    const auto from = line.size();
    line.resize(from + size);
    const auto got = source.read(from, line.data() + from, size);
    if (got < 0) return Error{path + ":1", reading_problem(got)};
    line.resize(from + static_cast<std::size_t>(got));
    if (const auto end = line.find('\n', from); end != line.npos) return line.substr(0, end);
    if (static_cast<std::size_t>(got) < size) break;
  }
  return line;
}

}  // namespace

Result<std::shared_ptr<const LogSource>> source_of_log(const std::string& path) {
  auto file = unpacked_source(path);
  if (!file) return file;
  const auto header = first_line(**file, path);
  if (!header) return header.error();
  auto whole = with_documents(*header, path);
  if (!whole) return whole.error();
  if (*whole != *header) *file = std::make_shared<const WithDocuments>(*std::move(whole), *file, header->size());
  return file;
}

Outcome read_pieces(const LogSource& source, const std::string& path,
                    const std::function<void(std::string_view)>& use) {
  std::string piece(block_bytes, '\0');
  for (std::uint64_t offset = 0;;) {
    const auto got = source.read(offset, piece.data(), piece.size());
    if (got < 0) return Error{path, reading_problem(got)};
    if (got == 0) return std::nullopt;
    use(std::string_view(piece).substr(0, static_cast<std::size_t>(got)));
    offset += static_cast<std::uint64_t>(got);
  }
}

Result<std::string> read_run_log(const std::string& path) {
  const auto source = source_of_log(path);
  if (!source) return source.error();
  std::string text;
  if (auto problem = read_pieces(**source, path, [&](std::string_view piece) { text.append(piece); }))
    return *std::move(problem);
  return text;
}

std::string reading_problem(ssize_t got) {
  const auto packed = got < 0 ? unpacking_problem(errno) : "";
  return packed.empty() ? file_changed : packed;
}

Result<std::string> first_line(const std::string& path) {
  const auto file = unpacked_source(path);
  if (!file) return file.error();
  return first_line(**file, path);
}

bool is_run_log_name(std::string_view path) { return without_gzip_ending(path).ends_with(".jsonl"); }

}  // namespace continua
