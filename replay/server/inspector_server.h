// The inspector over HTTP: the page built into the program, and the API. Bound to this machine unless told otherwise.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "continua/core/result.h"

namespace continua {

class LiveSessions;

class InspectorServer {
 public:
  /// Serves these run files and the *.run.jsonl below these folders, and live sessions if `sessions` is not null; it
  /// ends them when it stops.
  explicit InspectorServer(std::vector<std::string> paths, std::shared_ptr<LiveSessions> sessions = nullptr);
  ~InspectorServer();

  /// Binds to `address` and `port`; 0 takes a free one. Gives the port. From then on connections queue until run().
  /// `token`: that requests must have; empty: none (access.h). Error: in use, and the next port that is free.
  Result<int> listen(const std::string& address = "127.0.0.1", int port = 0, const std::string& token = "");

  /// Answers requests until stop(). REQUIRES listen() was ok.
  void run();

  /// May be called from any thread.
  void stop();

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace continua
