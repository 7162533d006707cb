// The one way in which the program puts a whole file in the place of another. Whatever ends the program, a full disk or
// a signal, the old file or the new one is there, never a part. Under a name that ends with .gz the file is packed with
// gzip, in blocks (gzip_blocks.h).
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"

namespace continua {

class ReplacedFile {
 public:
  /// Where the path is a link, the linked file is replaced, or the link itself. The latter for names that somebody else
  /// may have chosen.
  enum class Links { follow, replace };

  /// Writes beside the file, to one that has no name or one that nobody else has. A path that is a device or a pipe is
  /// written to as it is.
  explicit ReplacedFile(const std::string& path, Links links = Links::follow);
  /// Without a commit nothing has changed.
  ~ReplacedFile();
  ReplacedFile(const ReplacedFile&) = delete;
  ReplacedFile& operator=(const ReplacedFile&) = delete;

  /// Fails at once if the file cannot be written, and if it can be written no further.
  std::ostream& stream();

  /// Everything is on the disk, and in its place. Error: it is not, and why; then the old file is as it was.
  Outcome commit();

 private:
  class Buffer;
  std::unique_ptr<Buffer> buffer_;
  std::ostream stream_;
};

/// Error: it cannot be written, and why.
Outcome replace_file(const std::string& path, std::string_view content,
                     ReplacedFile::Links links = ReplacedFile::Links::follow);

/// An error where one of the outputs is one of the inputs, by its own name or another. Names that are no files are no
/// trouble. Each file is looked at once.
Outcome not_an_input(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs);

}  // namespace continua
