// Writes a film: frames in, an mp4 file (H.264) out, by the program ffmpeg.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include <sys/types.h>

#include "continua/core/result.h"
#include "continua/simulation/renderer.h"

namespace continua {

/// Until finish() the film is under another name, "NAME.part", which is gone if it is not finished.
class FilmWriter {
 public:
  /// REQUIRES even sides. Errors: ffmpeg is not there; the file cannot be written.
  static Result<FilmWriter> open(const std::string& path, ImageSize size, int frames_per_second);
  ~FilmWriter();
  FilmWriter(FilmWriter&& other) noexcept;
  FilmWriter& operator=(FilmWriter&&) = delete;

  /// One frame as Canvas::bgrx() gives it.
  Outcome add(std::string_view bgrx);
  /// No more frames; the film gets its name.
  Outcome finish();

 private:
  FilmWriter() = default;
  /// ffmpeg's complaint.
  Error complaint() const;

  std::string path_, part_;
  int pipe_ = -1;
  pid_t process_ = -1;
  std::FILE* messages_ = nullptr;
};

}  // namespace continua
