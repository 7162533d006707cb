#include "continua/replay/pictures/film_writer.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "continua/core/put_in_place.h"

extern char** environ;

namespace continua {
namespace {

// Raw pictures come in by the standard input; a film that any browser plays is written to `part`.
std::vector<std::string> ffmpeg_words(const std::string& part, ImageSize size, int frames_per_second) {
  const auto sides = fmt::format("{}x{}", size.width, size.height);
  const auto pace = std::to_string(frames_per_second);
  // clang-format off
  return {"ffmpeg", "-hide_banner", "-loglevel", "error", "-y",
          "-f", "rawvideo", "-pix_fmt", "bgr0", "-s", sides, "-r", pace, "-i", "pipe:0",
          "-an", "-c:v", "libx264", "-preset", "veryfast", "-crf", "20", "-pix_fmt", "yuv420p",
          "-movflags", "+faststart", "-f", "mp4", "file:" + part};
  // clang-format on
}

// Starts the program that reads `in` and writes its complaints to `messages`. An error number, 0 for none.
int start(std::vector<std::string> words, int in, std::FILE* messages, pid_t& process) {
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, in, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(messages), STDERR_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  // In a group of its own: an interrupt from the keyboard is ours to answer.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int failed = posix_spawnp(&process, arguments[0], &actions, &attributes, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  posix_spawnattr_destroy(&attributes);
  return failed;
}

}  // namespace

Result<FilmWriter> FilmWriter::open(const std::string& path, ImageSize size, int frames_per_second) {
  require(size.width % 2 == 0 && size.height % 2 == 0, "a film's sides must be even");
  FilmWriter film;
  film.path_ = path;
  film.part_ = path + ".part";
  std::FILE* const writable = std::fopen(film.part_.c_str(), "wb");
  if (!writable) return Error{path, fmt::format("cannot be written: {}", std::strerror(errno))};
  std::fclose(writable);
  film.messages_ = std::tmpfile();
  int ends[2];
  if (!film.messages_ || pipe2(ends, O_CLOEXEC) != 0)
    return Error{path, fmt::format("ffmpeg cannot be started: {}", std::strerror(errno))};
  film.pipe_ = ends[1];
  std::signal(SIGPIPE, SIG_IGN);  // that ffmpeg has ended is told by write()

  const int failed = start(ffmpeg_words(film.part_, size, frames_per_second), ends[0], film.messages_, film.process_);
  ::close(ends[0]);
  if (failed != 0) {
    film.process_ = -1;
    return Error{path, fmt::format("films need the program ffmpeg (Debian's package ffmpeg): {}",
                                   failed == ENOENT ? "it is not installed" : std::strerror(failed))};
  }
  return film;
}

FilmWriter::FilmWriter(FilmWriter&& other) noexcept
    : path_(std::move(other.path_)),
      part_(std::exchange(other.part_, {})),
      pipe_(std::exchange(other.pipe_, -1)),
      process_(std::exchange(other.process_, -1)),
      messages_(std::exchange(other.messages_, nullptr)) {}

FilmWriter::~FilmWriter() {
  if (process_ > 0) {
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
  }
  if (pipe_ >= 0) ::close(pipe_);
  if (messages_) std::fclose(messages_);
  std::error_code ignored;
  if (!part_.empty()) std::filesystem::remove(part_, ignored);
}

Outcome FilmWriter::add(std::string_view bgrx) {
  while (!bgrx.empty()) {
    const auto written = ::write(pipe_, bgrx.data(), bgrx.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return complaint();
    bgrx.remove_prefix(static_cast<std::size_t>(written));
  }
  return std::nullopt;
}

Outcome FilmWriter::finish() {
  ::close(std::exchange(pipe_, -1));
  int status = 0;
  while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) continue;
  process_ = -1;
  if (status != 0) return complaint();
  if (auto problem = put_in_place(part_, path_)) return *std::move(problem);
  part_.clear();
  return std::nullopt;
}

Error FilmWriter::complaint() const {
  std::rewind(messages_);
  std::string last(300, '\0');
  last.resize(std::fread(last.data(), 1, last.size(), messages_));
  while (!last.empty() && last.back() == '\n') last.pop_back();
  return {path_, "ffmpeg could not write the film: " + (last.empty() ? "it ended early" : last)};
}

}  // namespace continua
