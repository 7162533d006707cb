#include "continua/core/put_in_place.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>

namespace continua {

Outcome put_in_place(const std::string& part, const std::string& path) {
  const int file = ::open(part.c_str(), O_RDONLY | O_CLOEXEC);
  int problem = file < 0 || ::fsync(file) != 0 ? errno : 0;
  if (file >= 0) ::close(file);
  if (problem == 0 && std::rename(part.c_str(), path.c_str()) != 0) problem = errno;
  if (problem == 0) return std::nullopt;
  return Error{path, fmt::format("cannot be written: {}", std::strerror(problem))};
}

}  // namespace continua
