#include "continua/core/growing_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include <fmt/format.h>

namespace continua {
namespace {

int flags_of(GrowingFile::Begin begin) {
  switch (begin) {
    case GrowingFile::Begin::anew:
      return O_TRUNC;
    case GrowingFile::Begin::first:
      return O_EXCL;
    case GrowingFile::Begin::after:
      return O_APPEND;
  }
  return 0;
}

}  // namespace

GrowingFile::GrowingFile(const std::string& path, Begin begin) : path_(path) {
  file_ = ::open(path.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC | flags_of(begin), 0666);
  struct stat there {};
  if (file_ < 0 || ::fstat(file_, &there) != 0) problem_ = errno;
  begin_ = static_cast<std::uint64_t>(there.st_size);
}

Outcome GrowingFile::add(std::string_view piece) {
  if (problem_ != 0) return fault();
  for (auto left = piece; problem_ == 0 && !left.empty();) {
    const auto put = ::write(file_, left.data(), left.size());
    if (put > 0)
      left.remove_prefix(static_cast<std::size_t>(put));
    else if (errno != EINTR)
      problem_ = errno;
  }
  if (problem_ == 0)
    bytes_ += piece.size();
  else if (::ftruncate(file_, static_cast<off_t>(begin_ + bytes_)) != 0)
    return fault();  // a pipe or a device, which has no parts
  return outcome();
}

// Devices and pipes need none.
Outcome GrowingFile::sync() {
  const std::lock_guard lock(open_);
  if (file_ >= 0 && ::fdatasync(file_) != 0 && errno != EINVAL && errno != EROFS) problem_ = errno;
  return outcome();
}

Outcome GrowingFile::close() {
  (void)sync();
  const std::lock_guard lock(open_);
  if (file_ < 0) return outcome();
  // Some file systems tell only now that they were full.
  if (::close(std::exchange(file_, -1)) != 0 && problem_ == 0) problem_ = errno;
  return outcome();
}

Error GrowingFile::fault() const { return {path_, fmt::format("cannot be written: {}", std::strerror(problem_))}; }

Outcome GrowingFile::outcome() const { return problem_ == 0 ? Outcome() : fault(); }

}  // namespace continua
