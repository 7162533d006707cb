// Where the bodies of a run were at each instant, from its log's `pose` records.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/core/sim_time.h"
#include "continua/replay/log/run_index.h"
#include "continua/world/geometry.h"

namespace continua {

class RunMotion {
 public:
  /// Errors, with the line: the log has no scene with its bodies; a pose is malformed.
  static Result<RunMotion> read(const RunIndex& run);

  /// The scene's complete MJCF.
  const std::string& mjcf() const { return mjcf_; }
  const std::map<std::string, Pose>& at_start() const { return at_start_; }

  /// Poses of all bodies; between two records the way from one to the other.
  std::map<std::string, Pose> at(SimTime t) const;

  /// The times at which something moved, in order.
  const std::vector<SimTime>& moved() const { return moved_; }

 private:
  struct Sample {
    SimTime t{};
    Pose pose;
  };
  std::string mjcf_;
  std::map<std::string, Pose> at_start_;
  std::map<std::string, std::vector<Sample>> samples_;
  std::vector<SimTime> moved_;
};

}  // namespace continua
