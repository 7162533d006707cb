// Body poses at any instant of a run. The log is read lazily; every so many poses a keyframe remembers the last record
// for each body.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/sim_time.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/scene/run_points.h"

namespace continua {

using BodyPoses = std::map<std::string, PoseNumbers>;

/// Safe to use from several threads. Malformed poses are passed over, as are bodies beyond the first 10,000.
class RunPoses {
 public:
  explicit RunPoses(std::shared_ptr<const RunIndex> run);

  /// Of all bodies, as they were logged last at or before `t`; before anything has moved, as the header has them.
  BodyPoses at(SimTime t);

  struct Change {
    SimTime t{};
    BodyPoses bodies;  ///< those that moved
  };
  struct Changes {
    std::vector<Change> list;     ///< in order of time, one an instant
    std::optional<SimTime> next;  ///< where there are more: the last that is told of
  };
  /// Those in (from, to], at most so many of them.
  Changes changes(SimTime from, SimTime to, std::size_t most);

 private:
  using Latest = std::vector<std::uint32_t>;  // of each body: 1 + place in records_ of the last that tells of it, or 0
  void note(std::size_t place, Latest& latest);
  Latest latest_before(std::size_t place);
  std::size_t records_until(SimTime t) const;

  std::shared_ptr<const RunIndex> run_;
  BodyPoses at_start_;
  std::vector<std::uint32_t> records_;  // of kind pose
  std::vector<SimTime> times_;          // of these, never going back
  std::size_t stride_ = 1;              // records_ between two keyframes
  std::mutex mutex_;
  std::vector<Latest> keyframes_;  // before the records_ at 0, stride_, 2 stride_, …
  std::vector<std::string> names_;
  std::unordered_map<std::string, std::uint32_t> numbers_;  // places in names_
};

}  // namespace continua
