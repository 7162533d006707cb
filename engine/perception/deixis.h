// Finds where the human points, from faulty samples: trackers flicker between hands, drop out, and throw points
// kilometres away when an arm is nearly level (SEMANTICS.md §3). The result is a place on the table with a spread and a
// time. DEIXIS.md has the method and the sources of its numbers.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/core/sim_time.h"
#include "continua/perception/input_event.h"
#include "continua/world/geometry.h"

namespace continua {

/// A hand that stays this long is pointing; one that stays less may be on its way. Time counts with the confidence of
/// the samples: at half of it a hand has to stay twice as long.
inline constexpr double least_dwell_s = 0.3;
/// Samples of one hand farther apart in time than this say nothing about the time between them.
inline constexpr double longest_dropout_s = 0.5;

/// Trackers send a sample at least as often as this, seconds: 10 Hz, and half as much again.
inline constexpr double alone_s = 0.15;

/// A steady pointing of one hand: a fixation found in samples, or the stroke of a gesture with a target.
struct Deixis {
  SimTime from, until;
  std::string hand;                       ///< "left", "right" or empty
  Vec3 place_W = Vec3::Zero();            ///< on the table's plane; the robust centre of its samples
  double spread_m = 0;                    ///< robust standard deviation of the samples around it, along the worse axis
  std::optional<double> distance_m = {};  ///< from the hand, where a ray tells it; the median of its samples
  bool gesture = false;                   ///< a gesture's own target; else found in samples
  bool begun = false;             ///< a gesture of which the beginning alone is told: its target may be on the way
  bool followed = false;          ///< samples of its hand came after that beginning
  double confidence = 1;          ///< mean confidence of its samples
  int samples = 0, left_out = 0;  ///< number of its samples, and of samples in its time that were not believed
  std::vector<int> serials;       ///< of the inputs of its samples, in order of time, without the left-out ones
};

/// The time from which it is known to be a pointing, if no more samples come: it lasted long enough, or it is over. A
/// gesture of which the beginning alone is told waits for the samples of its hand.
SimTime settled_at(const Deixis& deixis);

/// One sample with its place.
struct PointingSample {
  SimTime t, until;
  std::string hand;
  Vec3 place_W = Vec3::Zero();  ///< not finite if it misses the table's plane
  double confidence = 1;
  int serial = 0;
  std::optional<double> distance_m = {};  ///< from the hand, where a ray tells it
};

/// The samples of the last seconds, the latest 1024 at most: a value. Its answers depend only on the samples' times,
/// not on the order in which they were added.
class PointingTrack {
 public:
  /// `area`: places beyond its x and y are not believed, because nobody points there on purpose.
  explicit PointingTrack(Box area) : area_(area) {}

  /// Adds a `pointing` event; other events are ignored. `serial` names the input.
  void add(const InputEvent& event, int serial);

  /// Steady pointings in the samples so far that overlap [from, until], in order of time.
  std::vector<Deixis> fixations(SimTime from, SimTime until) const;

  /// Whether there are samples of the gesture's hand after its beginning.
  bool follows(const Deixis& gesture) const;

  /// Forgets samples that ended before `t`.
  void forget_before(SimTime t);
  /// Forgets the samples of the fixation, and other samples of its hand in its time.
  void forget(const Deixis& fixation);

 private:
  static constexpr std::size_t most_samples = 1024;

  Box area_;
  std::vector<PointingSample> samples_;  // in order of time, then hand, place and serial
};

/// Whether the fixation is made with the gesture: by the same hand, and while it lasts or just after its beginning.
bool is_part_of(const Deixis& fixation, const Deixis& gesture);

/// The gesture with the place, the end and the samples of its fixations if its beginning alone is told, else as it is.
Deixis with_dwell(Deixis gesture, const std::vector<Deixis>& fixations);

/// A gesture with a target as a pointing, from its start to its end; none for the phase `stop`.
std::optional<Deixis> deixis_of(const InputEvent& event, int serial);

}  // namespace continua
