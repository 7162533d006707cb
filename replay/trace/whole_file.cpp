#include "continua/replay/trace/whole_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include <fmt/format.h>

namespace continua {

Outcome write_whole_file(const std::string& path, std::string_view content) {
  std::ofstream file(path, std::ios::binary);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file) return Error{path, fmt::format("cannot be written: {}", std::strerror(errno))};
  return std::nullopt;
}

}  // namespace continua
