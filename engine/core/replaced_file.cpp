#include "continua/core/replaced_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <map>
#include <optional>
#include <streambuf>
#include <utility>

#include <fmt/format.h>

#include "continua/core/gzip_blocks.h"
#include "continua/core/gzip_name.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

constexpr mode_t usual_mode = 0666;  // without the umask
constexpr int names_tried = 1000;

std::string folder_of(const std::string& path) {
  const auto folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

// Calls `make` with names in the folder until one is free. Gives that name, or none and errno.
template <class Make>
std::string with_free_name(const std::string& folder, Make make) {
  static std::atomic<int> last = 0;
  for (int i = 0; i < names_tried; ++i) {
    auto name = fmt::format("{}/.continua-{}-{}.part", folder, ::getpid(), ++last);
    if (make(name)) return name;
    if (errno != EEXIST) return "";
  }
  return "";
}

}  // namespace

// Counts what was written, and nothing else.
class ReplacedFile::Buffer : public std::streambuf {
 public:
  Buffer(const std::string& path, Links links) : path_(path), target_(path) {
    if (is_gzip_name(path)) packed_.emplace();
    struct stat there {};
    const bool exists = (links == Links::follow ? ::stat : ::lstat)(path.c_str(), &there) == 0;
    if (exists && !S_ISREG(there.st_mode) && !S_ISLNK(there.st_mode)) {
      file_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
      aside_ = false;
    } else {
      std::error_code unknown;
      if (links == Links::follow && fs::is_symlink(path, unknown)) {
        const auto linked = fs::weakly_canonical(path, unknown);
        if (!unknown) target_ = linked.string();
      }
      open_aside();
      if (file_ >= 0 && exists && S_ISREG(there.st_mode)) ::fchmod(file_, there.st_mode & 07777);
    }
    if (file_ < 0) problem_ = errno;
    setp(part_.data(), part_.data() + part_.size());
  }

  ~Buffer() override {
    if (file_ >= 0) ::close(file_);
    if (!name_.empty()) ::unlink(name_.c_str());
  }

  Outcome commit() {
    if (problem_ == 0) put();
    if (problem_ == 0 && packed_) write(packed_->finish());
    if (problem_ == 0 && aside_) {
      if (::fsync(file_) != 0) problem_ = errno;
      if (problem_ == 0 && name_.empty()) give_name();
    }
    // Some file systems tell only now that they were full.
    if (file_ >= 0 && ::close(file_) != 0 && problem_ == 0) problem_ = errno;
    file_ = -1;
    if (problem_ == 0 && aside_) {
      if (std::rename(name_.c_str(), target_.c_str()) != 0)
        problem_ = errno;
      else
        name_.clear();
    }
    if (problem_ == 0) return std::nullopt;
    return Error{path_, fmt::format("cannot be written: {}", std::strerror(problem_))};
  }

 protected:
  int_type overflow(int_type letter) override {
    if (!put()) return traits_type::eof();
    if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
    return sputc(traits_type::to_char_type(letter));
  }
  // A piece that would fill the part again and again goes past it.
  std::streamsize xsputn(const char* piece, std::streamsize size) override {
    if (packed_ || static_cast<std::size_t>(size) < part_.size()) return std::streambuf::xsputn(piece, size);
    if (put()) write({piece, static_cast<std::size_t>(size)});
    return problem_ == 0 ? size : 0;
  }
  // Nobody can look at it yet.
  int sync() override { return problem_ == 0 ? 0 : -1; }

 private:
  // A file without a name is gone with the program, if it does not come so far. Not all file systems have them.
  void open_aside() {
    const auto folder = folder_of(target_);
    file_ = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, usual_mode);
    if (file_ >= 0 || errno == ENOENT || errno == EACCES || errno == ENOTDIR) return;
    name_ = with_free_name(folder, [&](const std::string& name) {
      file_ = ::open(name.c_str(), O_CREAT | O_EXCL | O_NOFOLLOW | O_WRONLY | O_CLOEXEC, usual_mode);
      return file_ >= 0;
    });
  }

  void give_name() {
    const auto open_one = fmt::format("/proc/self/fd/{}", file_);
    name_ = with_free_name(folder_of(target_), [&](const std::string& name) {
      return ::linkat(AT_FDCWD, open_one.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    });
    if (name_.empty()) problem_ = errno;
  }

  bool put() {
    const std::string_view part(pbase(), static_cast<std::size_t>(pptr() - pbase()));
    if (packed_)
      write(packed_->add(part));
    else
      write(part);
    setp(part_.data(), part_.data() + part_.size());
    return problem_ == 0;
  }

  void write(std::string_view bytes) {
    while (problem_ == 0 && !bytes.empty()) {
      const auto put = ::write(file_, bytes.data(), bytes.size());
      if (put < 0 && errno != EINTR) problem_ = errno;
      if (put > 0) bytes.remove_prefix(static_cast<std::size_t>(put));
    }
  }

  const std::string path_;
  std::string target_, name_;  // name_: of the file beside, where it has one
  int file_ = -1, problem_ = 0;
  bool aside_ = true;
  std::optional<GzipBlocks> packed_;
  std::array<char, 65536> part_;
};

ReplacedFile::ReplacedFile(const std::string& path, Links links)
    : buffer_(std::make_unique<Buffer>(path, links)), stream_(buffer_.get()) {
  if (buffer_->pubsync() != 0) stream_.setstate(std::ios::badbit);
}

ReplacedFile::~ReplacedFile() = default;

std::ostream& ReplacedFile::stream() { return stream_; }

Outcome ReplacedFile::commit() { return buffer_->commit(); }

Outcome replace_file(const std::string& path, std::string_view content, ReplacedFile::Links links) {
  ReplacedFile file(path, links);
  file.stream().write(content.data(), static_cast<std::streamsize>(content.size()));
  return file.commit();
}

namespace {

// Which file it is, whatever its names; nothing if it is none.
std::optional<std::pair<dev_t, ino_t>> identity_of(const std::string& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return std::pair(status.st_dev, status.st_ino);
}

}  // namespace

Outcome not_an_input(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  std::map<std::pair<dev_t, ino_t>, std::string> read;
  for (const auto& output : outputs) {
    const auto file = identity_of(output);
    if (!file) continue;
    if (read.empty())
      for (const auto& input : inputs)
        if (const auto known = identity_of(input)) read.emplace(*known, input);
    const auto input = read.find(*file);
    if (input != read.end())
      return Error{output, fmt::format("is also the output{}; expected another file",
                                       input->second == output ? "" : ", and is read as " + input->second)};
  }
  return std::nullopt;
}

}  // namespace continua
