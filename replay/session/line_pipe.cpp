#include "continua/replay/session/line_pipe.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace continua {
namespace {

constexpr std::size_t longest_answer = std::size_t{1} << 20;  // bytes
constexpr int patience_ms = 60'000;
constexpr int rounds_of_parting = 200;
constexpr std::chrono::milliseconds round_of_parting{10};

Error cannot(const char* what) { return {"", fmt::format("{}: {}", what, std::strerror(errno))}; }

// In the new process: the command takes its place.
[[noreturn]] void become(const std::string& command, int socket) {
  if (dup2(socket, STDIN_FILENO) >= 0 && dup2(socket, STDOUT_FILENO) >= 0)
    execl("/bin/sh", "sh", "-c", command.c_str(), static_cast<char*>(nullptr));
  _exit(127);
}

}  // namespace

Result<std::unique_ptr<LinePipe>> LinePipe::open(const std::string& command) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) return cannot("it has no pipe");
  const int process = fork();
  if (process == 0) become(command, ends[1]);
  close(ends[1]);
  if (process < 0) {
    close(ends[0]);
    return cannot("it cannot be started");
  }
  return std::unique_ptr<LinePipe>(new LinePipe(ends[0], process));
}

LinePipe::~LinePipe() {
  close(socket_);
  for (int round = 0; round < rounds_of_parting; ++round) {
    if (waitpid(process_, nullptr, WNOHANG) != 0) return;
    std::this_thread::sleep_for(round_of_parting);
  }
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

Result<std::string> LinePipe::ask(const std::string& line) {
  const auto text = line + '\n';
  for (std::size_t sent = 0; sent < text.size();) {
    const auto count = send(socket_, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return Error{"", "the command has ended"};
    sent += static_cast<std::size_t>(count);
  }
  for (;;) {
    if (const auto end = received_.find('\n'); end != std::string::npos) {
      auto answer = received_.substr(0, end);
      received_.erase(0, end + 1);
      return answer;
    }
    if (received_.size() > longest_answer) return Error{"", "the command's line does not end"};
    pollfd waiting{socket_, POLLIN, 0};
    const int ready = poll(&waiting, 1, patience_ms);
    if (ready < 0 && errno == EINTR) continue;
    if (ready <= 0) return Error{"", "the command did not answer within a minute"};
    std::array<char, 4096> piece{};
    const auto count = recv(socket_, piece.data(), piece.size(), 0);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return Error{"", "the command has ended"};
    received_.append(piece.data(), static_cast<std::size_t>(count));
  }
}

}  // namespace continua
