#include "continua/replay/log/log_source.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <utility>

namespace continua {
namespace {

class Text : public LogSource {
 public:
  explicit Text(std::string text) : text_(std::move(text)) {}

  ssize_t read(std::uint64_t offset, char* into, std::size_t size) const override {
    if (offset >= text_.size()) return 0;
    return static_cast<ssize_t>(text_.copy(into, size, offset));
  }

 private:
  std::string text_;
};

class File : public LogSource {
 public:
  explicit File(const std::string& path) : descriptor_(::open(path.c_str(), O_RDONLY | O_CLOEXEC)) {}
  ~File() override {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  bool readable() const {
    struct stat status {};
    return descriptor_ >= 0 && ::fstat(descriptor_, &status) == 0 && S_ISREG(status.st_mode);
  }

  ssize_t read(std::uint64_t offset, char* into, std::size_t size) const override {
    std::size_t done = 0;
    while (done < size) {
      const auto got = ::pread(descriptor_, into + done, size - done, static_cast<off_t>(offset + done));
      if (got < 0 && errno == EINTR) continue;
      if (got < 0) return -1;
      if (got == 0) break;
      done += static_cast<std::size_t>(got);
    }
    return static_cast<ssize_t>(done);
  }

 private:
  int descriptor_;
};

}  // namespace

std::shared_ptr<const LogSource> source_of_text(std::string text) {
  return std::make_shared<const Text>(std::move(text));
}

std::shared_ptr<const LogSource> source_of_file(const std::string& path) {
  auto file = std::make_shared<const File>(path);
  return file->readable() ? file : nullptr;
}

}  // namespace continua
