// A run log on its way into a file.
#pragma once

#include <memory>
#include <ostream>
#include <string>

#include "continua/core/replaced_file.h"
#include "continua/core/result.h"

namespace continua {

/// Takes the bytes of a whole log and puts them into a file that takes the place of another. With a folder for
/// documents, the large members of the first line go there (kept_documents.h).
class RunLogFile {
 public:
  /// `documents`: a folder, which is made if it is not there; empty: the file has everything.
  explicit RunLogFile(const std::string& path, const std::string& documents = "");
  ~RunLogFile();

  /// Fails at once if the file cannot be written, and if it can be written no further.
  std::ostream& stream() { return stream_; }

  /// Everything is on the disk, and in its place. Error: it is not, and why; then the old file is as it was.
  Outcome commit();

 private:
  class Buffer;
  ReplacedFile file_;
  std::unique_ptr<Buffer> buffer_;
  std::ostream stream_;
};

/// Writes the log in `from` to `path`, which may be the same file.
Outcome rewrite_run_log(const std::string& from, const std::string& path, const std::string& documents = "");

}  // namespace continua
