// The place where the human points, from samples that lie: trackers flicker between hands, drop out, and throw points
// kilometres away when an arm is nearly level (SEMANTICS.md §3). The result is a region of the table and a time.
// DEIXIS.md tells the method and the source of its numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/core/sim_time.h"
#include "continua/perception/input_event.h"
#include "continua/world/geometry.h"

namespace continua {

/// A hand that has stayed so long is pointing; shorter than that it may be on its way.
inline constexpr double least_dwell_s = 0.3;
/// The longest time between two samples of one hand that still belong together.
inline constexpr double longest_dropout_s = 0.5;

/// A steady pointing of one hand: a fixation found in samples, or the stroke of a gesture that named its target.
struct Deixis {
  SimTime from, until;
  std::string hand;               ///< "left", "right" or empty
  Vec3 place_W = Vec3::Zero();    ///< on the table's plane; the robust centre of its samples
  double spread_m = 0;            ///< robust standard deviation of the samples around it, along the worse axis
  bool gesture = false;           ///< a gesture's own target; else found in samples
  double confidence = 1;          ///< the mean of its samples'
  int samples = 0, left_out = 0;  ///< how many samples it is made of, and how many in its time were not believed
  std::vector<int> serials;  ///< of the inputs it is made of, in order of their times, left_out ones not among them
};

/// When it is known to have been a pointing, if nothing more is heard of it: it lasted, or it is over.
SimTime settled_at(const Deixis& deixis);

/// One sample with its place.
struct PointingSample {
  SimTime t, until;
  std::string hand;
  Vec3 place_W = Vec3::Zero();  ///< not finite if the hand points past the table's plane
  double confidence = 1;
  int serial = 0;
};

/// The samples of the last seconds, the latest 1024 at most: a value. Its answers depend on the samples' times alone,
/// not on the order in which they were added.
class PointingTrack {
 public:
  /// `area`: places beyond its x and y are not believed: nobody points there on purpose. `serial` names the input.
  explicit PointingTrack(Box area) : area_(area) {}

  /// A `pointing` event; others are ignored.
  void add(const InputEvent& event, int serial);

  /// Steady pointings that overlap [from, until], in order of time, as far as the samples so far tell.
  std::vector<Deixis> fixations(SimTime from, SimTime until) const;

  /// Forgets samples that ended before `t`.
  void forget_before(SimTime t);
  /// Forgets the samples that it is made of, and those of its hand in its time.
  void forget(const Deixis& fixation);

 private:
  static constexpr std::size_t most_samples = 1024;

  Box area_;
  std::vector<PointingSample> samples_;  // in order of time, then hand, place and serial
};

/// The pointing that a gesture with a target is, from its start to its end; none of a gesture's stop.
std::optional<Deixis> deixis_of(const InputEvent& event, int serial);

}  // namespace continua
