// The start page's lines: the content of each run of a library in brief, worked out once for each state of its file.
#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/replay/inspector/run_library.h"

namespace continua {

/// Safe to use from several threads.
class RunListings {
 public:
  explicit RunListings(RunLibrary& library) : library_(library) {}
  ~RunListings() { stop(); }

  /// From now on a thread reads the unread runs, the newest first, and calls `prepare` for the newest two.
  void start(std::function<void(const std::string& id)> prepare);
  /// Waits for the run that is being read.
  void stop();

  /// All runs, the newest first: {id, name, changed (seconds since 1970), live, bytes} and the members of
  /// run_listing(), or `error`. `live`: without its end, and being written. While the thread has yet to read a run it
  /// is `pending`, with the listing known before; without a thread all are read at once.
  Json all();

 private:
  struct Known {
    FileState state;
    Json line;
  };
  struct Listed {
    RunFile file;
    FileState state;
  };
  std::vector<Listed> newest_first();
  bool is_known(const Listed& one);
  void look_into(const Listed& one);
  void work();

  RunLibrary& library_;
  std::function<void(const std::string& id)> prepare_;
  std::thread thread_;
  std::mutex mutex_;  // guards the members below
  std::condition_variable wanted_changed_, known_changed_;
  bool wanted_ = false, stopping_ = false;
  std::map<std::string, Known> known_;  // by path
};

}  // namespace continua
