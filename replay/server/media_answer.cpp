#include "continua/replay/server/media_answer.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <memory>

#include <fmt/format.h>

#include "continua/replay/server/http_answer.h"
#include "continua/replay/server/http_head.h"
#include "continua/replay/server/http_library.h"

namespace continua {
namespace {

constexpr std::size_t at_once = 65536;

class OpenFile {
 public:
  explicit OpenFile(const std::string& path)
      : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW)) {
    struct stat state {};
    if (file_ >= 0 && ::fstat(file_, &state) == 0 && S_ISREG(state.st_mode))
      size_ = static_cast<std::uint64_t>(state.st_size);
  }
  ~OpenFile() {
    if (file_ >= 0) ::close(file_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  /// None: it is no file that can be read.
  std::optional<std::uint64_t> size() const { return size_; }
  ssize_t read(char* into, std::size_t size, std::uint64_t from) const {
    return ::pread(file_, into, size, static_cast<off_t>(from));
  }

 private:
  int file_;
  std::optional<std::uint64_t> size_;
};

std::optional<std::uint64_t> number_in(std::string_view digits) {
  std::uint64_t number = 0;
  const auto [end, problem] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (problem != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return number;
}

}  // namespace

std::optional<ByteRange> wanted_range(std::string_view range, std::uint64_t size) {
  constexpr std::string_view unit = "bytes=";
  if (!range.starts_with(unit)) return std::nullopt;
  range.remove_prefix(unit.size());
  const auto dash = range.find('-');
  if (dash == std::string_view::npos) return std::nullopt;
  const auto first = number_in(range.substr(0, dash)), last = number_in(range.substr(dash + 1));
  if (dash == 0) {
    if (!last) return std::nullopt;
    return ByteRange{size - std::min(*last, size), size};
  }
  if (!first || (!last && dash + 1 < range.size()) || (last && *last < *first)) return std::nullopt;
  if (*first >= size) return ByteRange{};
  return ByteRange{*first, last && *last < size ? *last + 1 : size};
}

void send_media(const httplib::Request& request, httplib::Response& response, const ServedMedia& media) {
  const auto file = std::make_shared<const OpenFile>(media.path);
  const auto size = file->size();
  if (!size) return send_answer(request, response, api_error(404, "the file cannot be read"));
  response.set_header("Cache-Control", "no-store");
  response.set_header("Accept-Ranges", "bytes");
  ByteRange part{0, *size};
  if (const auto wanted = wanted_range(request.get_header_value(passed_range), *size)) {
    part = {wanted->from, std::min(wanted->to, wanted->from + most_media_part)};
    response.set_header("Content-Range", part.from < part.to
                                             ? fmt::format("bytes {}-{}/{}", part.from, part.to - 1, *size)
                                             : fmt::format("bytes */{}", *size));
    response.status = part.from < part.to ? 206 : 416;
  }
  if (part.from == part.to) return response.set_content("", media.type);
  response.set_content_provider(static_cast<std::size_t>(part.to - part.from), media.type,
                                [file, part](std::size_t from, std::size_t length, httplib::DataSink& sink) {
                                  std::array<char, at_once> bytes;
                                  const auto got =
                                      file->read(bytes.data(), std::min(length, bytes.size()), part.from + from);
                                  return got > 0 && sink.write(bytes.data(), static_cast<std::size_t>(got));
                                });
}

}  // namespace continua
