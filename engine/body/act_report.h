// The body's account of an act.
#pragma once

#include <string>
#include <vector>

#include "continua/core/sim_time.h"

namespace continua {

struct ActReport {
  /// unstable: the object moved again within a second after the hand let go of it.
  enum class Status { started, done, missed, dropped, blocked, unreachable, unstable, stopped };
  int id = 0;
  SimTime t;
  Status status = Status::done;
  double position_error_m = 0;  ///< put, slide, push, move, turn: distance from the goal on the table plane
  std::string reason;           ///< a sentence: why the act was not done, or how it was done otherwise than asked
  std::vector<std::string> moved_aside = {};  ///< other objects that were put elsewhere to make room, in order
  double yaw_error = 0;  ///< between the object's yaw and the intended one, radians; 0 for round things
  std::vector<std::string> touches = {};  ///< contacts of the handled object in the end: objects, `table`
  std::vector<std::string> retries = {};  ///< why earlier attempts had failed, in order
};

/// `done`, `blocked` …
std::string name_of(ActReport::Status status);

}  // namespace continua
