// The instant of the run that a film shows at each of its times: happenings run at their own speed, long waits are
// shortened.
#pragma once

#include <utility>
#include <vector>

#include "continua/core/sim_time.h"

namespace continua {

class FilmClock {
 public:
  /// `busy`: when there is something to see or read, [from, until] in the run's time, in any order.
  FilmClock(std::vector<std::pair<SimTime, SimTime>> busy, SimTime end, bool real_time);

  SimTime film_end() const { return film_end_; }

  struct Instant {
    SimTime t{};           ///< of the run
    bool jumping = false;  ///< time is being passed over
  };
  /// `film_t` from 0 to film_end().
  Instant at(SimTime film_t) const;

 private:
  struct Stretch {
    SimTime film_from{}, from{}, until{};
    double speed = 1;  // the run's seconds in a second of film
  };
  std::vector<Stretch> stretches_;  // in order, without gaps
  SimTime film_end_{};
};

}  // namespace continua
