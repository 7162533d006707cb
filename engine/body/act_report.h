// The body's report about an act, at its beginning and at its end.
#pragma once

#include <string>
#include <vector>

#include "continua/body/reason.h"
#include "continua/core/sim_time.h"

namespace continua {

struct ActReport {
  using Status = ActStatus;
  int id = 0;
  SimTime t;
  Status status = Status::done;
  double position_error_m = 0;  ///< put, slide, push, move, turn: distance from the goal on the table plane
  Reason reason = {};           ///< why the act failed, or went otherwise than asked; else empty
  std::vector<std::string> moved_aside = {};  ///< other objects that had to make room, in order
  double yaw_error = 0;  ///< between the object's yaw and the intended one, radians; 0 for round things
  std::vector<std::string> touches = {};  ///< contacts of the handled object at the end: objects, `table`
  std::vector<Reason> retries = {};       ///< reasons of failed attempts before, in order

  /// The act ends for this reason, in the status of the reason.
  void end_for(Reason why) {
    status = status_of(why.code);
    reason = std::move(why);
  }
};

}  // namespace continua
