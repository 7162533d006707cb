// The runs that an inspector shows: files and folders on a command line, found anew on each request.
#pragma once

#include <cstdint>
#include <filesystem>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/result.h"
#include "replay/run_index.h"

namespace continua {

/// A run log among those served. Its id is its path below the folder given, made fit for an address; ids name runs
/// that exist and are never turned into paths.
struct RunFile {
  std::string id;
  std::string path;
  std::string name;             ///< for people: the id without its folder's marks
  std::string what_if_of = {};  ///< id of the run that it was made from; empty for those that were there
};

/// Safe to use from several threads.
class RunLibrary {
 public:
  /// Run files, or folders whose files named *.run.jsonl are meant, at any depth.
  explicit RunLibrary(std::vector<std::string> paths) : paths_(std::move(paths)) {}

  /// All runs there are now, in order of their paths; then those that were added.
  std::vector<RunFile> runs() const;

  /// One more run, made from another; gives its id, `name` where that is free.
  std::string add(const std::string& name, const std::string& path, const std::string& what_if_of);

  /// The index of a run, read again when the file has changed. Null index: no run has this id.
  Result<std::shared_ptr<const RunIndex>> open(const std::string& id);

 private:
  struct Held {
    std::string path;
    std::uintmax_t bytes;
    std::filesystem::file_time_type written;
    std::shared_ptr<const RunIndex> run;
  };
  std::vector<std::string> paths_;
  mutable std::mutex mutex_;
  std::vector<RunFile> added_;
  std::list<Held> held_;  // the last used first
};

}  // namespace continua
