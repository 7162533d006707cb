// The avatar's acts in a run, with their times, objects and goals, from the log (RUNLOG.md).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/core/sim_time.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/scene/run_points.h"

namespace continua {

struct RunAct {
  std::size_t n = 0;  ///< the record that tells of it first
  std::int64_t act = 0;
  std::string program, status;  ///< the last status there is
  SimTime from{}, until{};      ///< from when it was started, else asked for; until the run's end where it has none
  bool done = false;            ///< it has come to an end as it was meant to
  std::string object;           ///< the body that its program, else a step of it, names first; empty: none
  std::optional<Point> place;   ///< that its program, else a step of it, names
  std::string beside;  ///< the body that its program names as the place to go to: `plate` of on(plate); or empty
};

/// In order of their beginnings. Errors: a record cannot be read.
Result<std::vector<RunAct>> read_acts(const RunIndex& run, const std::set<std::string>& bodies);

}  // namespace continua
