#include "continua/replay/live/live_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include <fmt/format.h>

#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"

namespace continua {

bool is_avatars_move(std::string_view kind) { return log::is_any<log::Utterance, log::AvatarGesture, log::Act>(kind); }

LiveLog::LiveLog(const std::string& path)
    : file_(::open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0666)), stream_(this) {}

void LiveLog::close() {
  if (file_ < 0) return;
  ::fsync(file_);
  if (::close(std::exchange(file_, -1)) != 0) stream_.setstate(std::ios::badbit);
}

std::streamsize LiveLog::xsputn(const char* line, std::streamsize size) {
  for (std::streamsize done = 0; done < size;) {
    const auto put = ::write(file_, line + done, static_cast<std::size_t>(size - done));
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) {
      [[maybe_unused]] const int cut = ::ftruncate(file_, static_cast<off_t>(bytes_));
      return 0;
    }
    done += put;
  }
  bytes_ += static_cast<std::uint64_t>(size);
  std::string_view text(line, static_cast<std::size_t>(size));
  if (text.ends_with('\n')) text.remove_suffix(1);
  // Poses are most of a log, and long.
  static const auto pose = fmt::format("{{\"kind\":\"{}\"", log::Pose::kind.name);
  if (text.starts_with(pose)) return size;
  auto kind = member_in(text, "kind");
  if (kind.size() >= 2 && is_avatars_move(kind.substr(1, kind.size() - 2))) moves_.emplace_back(text);
  return size;
}

}  // namespace continua
