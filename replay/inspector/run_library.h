// The runs that an inspector shows: files and folders on a command line, found anew on each request.
#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// A file as it was when it was looked at.
struct FileState {
  std::uintmax_t bytes = 0;
  std::filesystem::file_time_type written{};
  bool operator==(const FileState&) const = default;
};
FileState file_state(const std::string& path);

/// A run log among those served. Its id is its path below the folder given, made fit for an address; ids name runs
/// that exist and are never turned into paths.
struct RunFile {
  std::string id;
  std::string path;
  std::string name;             ///< for people: the id without its folder's marks
  std::string what_if_of = {};  ///< the run that it was made from by replaying it otherwise; else empty
  std::string served = {};      ///< the folder given that it lies in, or its own folder
};

/// Safe to use from several threads: those that ask for other runs do not wait while one is read.
class RunLibrary {
 public:
  /// Run files, or folders whose files named *.run.jsonl or *.run.jsonl.gz are meant, at any depth.
  explicit RunLibrary(std::vector<std::string> paths) : paths_(std::move(paths)) {}

  /// All runs there are now, in order of their paths; then those that were added.
  std::vector<RunFile> runs();

  /// The run of this id, if there is one.
  std::optional<RunFile> find(const std::string& id);
  /// The folders among the paths.
  std::vector<std::string> folders() const;

  /// One more run, perhaps made from another; gives its id, `name` where that is free. One that is among those of the
  /// paths already is not added.
  std::string add(const std::string& name, const std::string& path, const std::string& what_if_of = "");

  /// Who knows whether this program itself is writing the log at a path. REQUIRES that nobody else asks yet.
  using IsOpen = std::function<bool(const std::string& path)>;
  void ask_whether_open(IsOpen is_open) { is_open_ = std::move(is_open); }
  /// Whether a log that has no end yet is being written: by this program, or by another, in the last seconds.
  bool is_being_written(const std::string& path, const FileState& log) const;

  /// The index of a run, read again when the file has changed; of a log that has grown, only the new part is read. Null
  /// index: no run has this id. The indexes used last stay in memory.
  Result<std::shared_ptr<const RunIndex>> open(const std::string& id);

  /// The same for one look: an index that is not in memory does not stay there.
  Result<std::shared_ptr<const RunIndex>> look_into(const RunFile& file);

 private:
  struct Held {
    explicit Held(std::string of) : path(std::move(of)) {}
    const std::string path;
    std::atomic<std::size_t> records = 0;
    std::mutex reading;  // guards the members below
    FileState state;
    std::shared_ptr<const RunIndex> run;
  };
  std::shared_ptr<Held> held(const std::string& path, bool make);
  static Result<std::shared_ptr<const RunIndex>> read(Held& held);

  std::vector<std::string> paths_;
  IsOpen is_open_;
  std::mutex mutex_;                      // guards the members below; never held while a file is read
  std::map<std::string, RunFile> known_;  // by id, as found last
  std::vector<RunFile> added_;
  std::list<std::shared_ptr<Held>> held_;  // the last used first
};

}  // namespace continua
