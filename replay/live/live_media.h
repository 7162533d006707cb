// A live session recorded by camera or microphone: the browser sends it bit by bit, and it is written beside
// the trace. Only if the human has agreed, in the page and in the browser (web/talk/filming.js).
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "continua/core/result.h"
#include "continua/core/sim_time.h"
#include "continua/replay/media/media_file.h"

namespace continua {

/// The most that all recordings of a session may have, in bytes: an hour and more of what browsers record.
inline constexpr std::uint64_t most_live_media = std::uint64_t{1} << 30;

/// A part of a recording.
struct MediaPart {
  std::string source;      ///< "camera" (with or without sound) or "microphone"
  std::string type;        ///< "video/webm;codecs=…" or "audio/webm;…", as the browser says
  std::uint64_t take = 0;  ///< which of the recordings from there: one that is stopped and begun again is another
  std::uint64_t part = 0;  ///< 0, 1, 2, … of the take
  SimTime at;              ///< of part 0: the session's time when it began
  std::string_view bytes;
};

/// Safe to use from several threads.
class LiveMedia {
 public:
  /// The recordings of the trace at this path lie beside it, "NAME.camera.webm"; an existing file is left alone.
  explicit LiveMedia(std::string trace_path) : trace_path_(std::move(trace_path)) {}

  /// The part is in the file from then on. A part that comes again is taken once. Errors: an unknown source or type, a
  /// part out of order, a recording that is too long, a file that cannot be written; the file then stays as it was.
  Outcome add(const MediaPart& part);

  /// No more parts. Gives the recordings as a trace's header has them. Where ffmpeg is installed it makes them such
  /// that players can find every instant.
  std::vector<MediaFile> finish();

 private:
  struct Growing {
    MediaFile file;
    std::string path;
    std::uint64_t parts = 0, bytes = 0;
  };
  Result<Growing> begun(const MediaPart& part) const;

  const std::string trace_path_;
  std::mutex mutex_;  // guards the members below
  std::vector<Growing> files_;
  std::map<std::pair<std::string, std::uint64_t>, std::size_t> known_;  // by source and take: the place in files_
  std::uint64_t bytes_ = 0;
  bool finished_ = false;
};

/// Writes the recordings into the header of the trace at this path, which nobody writes to any more.
Outcome name_media(const std::string& trace_path, const std::vector<MediaFile>& media);

}  // namespace continua
