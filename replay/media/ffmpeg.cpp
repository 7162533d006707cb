#include "continua/replay/media/ffmpeg.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>

#include <fmt/format.h>

extern char** environ;

namespace continua {
namespace {

using Clock = std::chrono::steady_clock;

// Others, such as lists of addresses, could make it read elsewhere.
constexpr auto formats = "matroska,webm,mov,mp4,m4a,3gp,3g2,mj2,wav,ogg,mp3,flac,mpeg,mpegts";

// An error number, 0 for none.
int start(std::vector<std::string> words, int out, pid_t& process) {
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  const int failed = posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  return failed;
}

// Until the other end is closed; false: it took too long.
bool read_all(int from, double most_s, const std::function<void(std::string_view)>& output) {
  const auto end = Clock::now() + std::chrono::duration<double>(most_s);
  std::array<char, 65536> part;
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - Clock::now()).count();
    pollfd waiting{from, POLLIN, 0};
    if (left <= 0) return false;
    if (::poll(&waiting, 1, static_cast<int>(left)) <= 0) continue;
    const auto got = ::read(from, part.data(), part.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return true;
    output({part.data(), static_cast<std::size_t>(got)});
  }
}

}  // namespace

Outcome run_ffmpeg(const std::string& recording, const std::vector<std::string>& words, double most_s,
                   const std::function<void(std::string_view)>& output) {
  std::vector<std::string> all = {"ffmpeg",
                                  "-nostdin",
                                  "-hide_banner",
                                  "-loglevel",
                                  "quiet",
                                  "-y",
                                  "-threads",
                                  "1",
                                  "-protocol_whitelist",
                                  "file,pipe",
                                  "-format_whitelist",
                                  formats,
                                  "-i",
                                  "file:" + recording};
  all.insert(all.end(), words.begin(), words.end());
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    return Error{recording, std::string("ffmpeg cannot be started: ") + std::strerror(errno)};
  pid_t process = -1;
  const int failed = start(std::move(all), ends[1], process);
  ::close(ends[1]);
  if (failed != 0) {
    ::close(ends[0]);
    return Error{recording, failed == ENOENT ? "needs the program ffmpeg, which is not installed"
                                             : std::string("ffmpeg cannot be started: ") + std::strerror(failed)};
  }
  const bool in_time = read_all(ends[0], most_s, output);
  ::close(ends[0]);
  if (!in_time) ::kill(process, SIGKILL);
  int status = 0;
  while (::waitpid(process, &status, 0) < 0 && errno == EINTR) continue;
  if (!in_time) return Error{recording, fmt::format("ffmpeg took longer than {:.0f} s with it", most_s)};
  if (status != 0) return Error{recording, "ffmpeg finds no sound or picture of that kind in it"};
  return std::nullopt;
}

}  // namespace continua
