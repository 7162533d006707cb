// Makes a program's writing fail, from outside: a library to be loaded before all others (LD_PRELOAD).
//
//   CONTINUA_FAIL="N:HOW"   the Nth call that changes a regular file or the name of one fails as HOW says
//     nospace     that call and all later ones, since the disk is full
//     io          that call alone, by an error of the disk
//     short       a write takes half of its bytes, and the program goes on; other calls do their work
//     interrupt   that call alone, by a signal that came
//     kill        half of a write is done, and the program is killed
//   CONTINUA_FAIL="0:FILE"  nothing fails; the number of such calls is written to FILE at the program's end
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace {

struct Plan {
  long number = -1;
  std::string how;

  Plan() {
    const char* text = std::getenv("CONTINUA_FAIL");
    if (!text) return;
    char* end = nullptr;
    number = std::strtol(text, &end, 10);
    how = *end == ':' ? end + 1 : "";
  }
};

const Plan& plan() {
  static const Plan made;
  return made;
}

std::atomic<long> calls = 0;

bool is_regular(int file) {
  struct stat there {};
  return ::fstat(file, &there) == 0 && S_ISREG(there.st_mode);
}

enum class Fate { done, failed, halved };

// The fate of the next call; errno is set where it fails.
Fate next_fate() {
  if (plan().number < 0) return Fate::done;
  const auto number = ++calls;
  const bool mine = number == plan().number, later = plan().number > 0 && number > plan().number;
  if (plan().how == "nospace" && (mine || later)) return errno = ENOSPC, Fate::failed;
  if (!mine) return Fate::done;
  if (plan().how == "io") return errno = EIO, Fate::failed;
  if (plan().how == "interrupt") return errno = EINTR, Fate::failed;
  return Fate::halved;
}

void end_if_killed() {
  if (plan().how == "kill") ::kill(::getpid(), SIGKILL);
}

template <class Function>
Function real(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

// A call that writes nothing: it is done, or it fails.
template <class Call>
int whole(Call call) {
  switch (next_fate()) {
    case Fate::failed:
      return -1;
    case Fate::halved:
      end_if_killed();
      break;
    case Fate::done:
      break;
  }
  return call();
}

struct Counted {
  ~Counted() {
    if (plan().number != 0) return;
    const auto text = std::to_string(calls) + "\n";
    const auto file = ::syscall(SYS_openat, AT_FDCWD, plan().how.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::syscall(SYS_write, file, text.data(), text.size());
  }
} counted;

}  // namespace

extern "C" {

__attribute__((visibility("default"))) ssize_t write(int file, const void* bytes, size_t size) {
  if (size > 0 && is_regular(file)) {
    const auto fate = next_fate();
    if (fate == Fate::failed) return -1;
    if (fate == Fate::halved) {
      const auto half = ::syscall(SYS_write, file, bytes, (size + 1) / 2);
      end_if_killed();
      return half;
    }
  }
  return ::syscall(SYS_write, file, bytes, size);
}

__attribute__((visibility("default"))) int fsync(int file) {
  return whole([&] { return static_cast<int>(::syscall(SYS_fsync, file)); });
}

__attribute__((visibility("default"))) int fdatasync(int file) {
  return whole([&] { return static_cast<int>(::syscall(SYS_fdatasync, file)); });
}

__attribute__((visibility("default"))) int rename(const char* from, const char* to) noexcept {
  return whole([&] { return static_cast<int>(::syscall(SYS_renameat, AT_FDCWD, from, AT_FDCWD, to)); });
}

__attribute__((visibility("default"))) int linkat(int from, const char* name, int to, const char* other,
                                                  int flags) noexcept {
  return whole([&] { return static_cast<int>(::syscall(SYS_linkat, from, name, to, other, flags)); });
}

__attribute__((visibility("default"))) int ftruncate(int file, off_t size) noexcept {
  return whole([&] { return static_cast<int>(::syscall(SYS_ftruncate, file, size)); });
}

}  // extern "C"
