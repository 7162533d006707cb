// The human's gaze: the objects looked at, and how salient that makes them.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/core/sim_time.h"

namespace continua {

/// A stretch of time in which the eyes stayed on one object.
struct Look {
  std::string object;           ///< empty: on none
  SimTime from, until;          ///< of its samples
  std::optional<SimTime> next;  ///< the first sample of the next look
  double confidence = 1;        ///< the mean over its samples
  int samples = 1;
  int serial = 0;  ///< of the input with which it began
};

/// An object with its salience: seconds of looking times confidence, each halved with every half-life after its end.
struct Salient {
  std::string object;
  double salience = 0;
  std::vector<int> serials;  ///< of the looks, ascending
};

/// One report of where the eyes are.
struct GazeSample {
  SimTime t, until;    ///< until: t if the tracker does not tell
  std::string object;  ///< the object there, or empty
  double confidence = 1;
  int serial = 0;
};

/// The looks of the last seconds: a value. A look goes on until the next sample, or as long after its last sample as
/// trackers drop out (perception/deixis.h).
class GazeTrack {
 public:
  /// Adds a sample. Samples that come after a later one are left out. Returns whether a new look began.
  bool add(const GazeSample& sample);

  /// The objects of at least this salience at `now`, the most salient first; ties go by the latest look, then by name.
  std::vector<Salient> salient(SimTime now, double half_life_s, double least) const;

 private:
  std::vector<Look> looks_;  // in order of time
};

}  // namespace continua
