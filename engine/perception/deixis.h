// Where the human points, from samples that lie: trackers flicker between hands, drop out, and throw points kilometres
// away when an arm is nearly level (semantics §3). What remains is a region of the table and a time.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/sim_time.h"
#include "perception/input_event.h"
#include "world/geometry.h"

namespace continua {

/// A steady pointing of one hand: a fixation found in samples, or the stroke of a gesture that named its target.
struct Deixis {
  SimTime from, until;
  std::string hand;             ///< "left", "right" or empty
  Vec3 place_W = Vec3::Zero();  ///< on the table's plane; the robust centre of its samples
  double spread_m = 0;          ///< robust standard deviation of the samples around it, along the worse axis
  bool gesture = false;         ///< a gesture's own target; else found in samples
  double confidence = 1;
  int samples = 0, left_out = 0;  ///< how many samples it is made of, and how many in its time were not believed
  std::vector<int> serials;  ///< of the inputs it is made of, in order of their times, left_out ones not among them
};

/// The samples of the last seconds: a value. What it answers depends on the samples' times alone, not on the order in
/// which they were added.
class PointingTrack {
 public:
  /// `area`: places beyond it are not believed: nobody points there on purpose. `serial` names the input.
  explicit PointingTrack(Box area) : area_(area) {}

  /// A `pointing` event; others are ignored.
  void add(const InputEvent& event, int serial);

  /// Steady pointings that overlap [from, until], in order of time, as far as the samples so far tell.
  std::vector<Deixis> fixations(SimTime from, SimTime until) const;

  /// Forgets samples before `t`.
  void forget_before(SimTime t);

 private:
  struct Sample;
  Box area_;
  std::vector<Sample> samples_;  // in order of time, then hand, then place
};

/// The pointing that a gesture with a target is, from its start to its end.
std::optional<Deixis> deixis_of(const InputEvent& event, int serial);

}  // namespace continua
