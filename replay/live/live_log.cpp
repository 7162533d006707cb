#include "continua/replay/live/live_log.h"

#include <fmt/format.h>

#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"

namespace continua {

bool is_avatars_move(std::string_view kind) { return log::is_any<log::Utterance, log::AvatarGesture, log::Act>(kind); }

std::streamsize LiveLog::xsputn(const char* line, std::streamsize size) {
  if (file_.add({line, static_cast<std::size_t>(size)})) return 0;
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
