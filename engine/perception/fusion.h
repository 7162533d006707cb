// Which pointing goes with which word (SEMANTICS.md §3, Ensembles). The result depends on event times, not on the order
// of arrival: arrivals that are out of order within `lateness` are put in order first. An event later than that still
// goes by its own time with anything that waits, but an ensemble that was complete before it came stays as it was.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

#include "continua/perception/binding.h"
#include "continua/perception/deixis.h"
#include "continua/perception/input_event.h"

namespace continua {

struct Readings;  // moves/readings.h

/// Something that happened, as it waits to be understood.
struct Percept {
  int serial = 0;  ///< of its input
  InputEvent event;
  std::optional<Deixis> deixis;                        ///< of a gesture that points
  std::vector<Taker> takers;                           ///< of speech
  std::shared_ptr<const Readings> readings = nullptr;  ///< of speech, where its words are understood
};

/// The unit of understanding: a percept with the pointings that go with it.
struct Ensemble {
  Percept percept;
  std::vector<std::optional<Deixis>> bound;  ///< one for each taker
  SimTime at;                                ///< when it was complete, in the time of events
};

/// The percepts that wait for their counterparts: a value.
///
/// - An utterance is complete when every taker that needs a pointing has one and the last such taker has been spoken
///   (perception/speech_times.h): until then a better pointing may come. A fixation counts once it is settled
///   (settled_at).
/// - Other speech waits until no pointing can come any more (`after` past the end of its last needing taker), and is
///   then released without.
/// - A gesture that points waits for speech that takes it until `after` past its end, and is released alone then. A
///   gesture taken by speech is not released at all; a pointing that was released alone can still be taken within
///   `before`.
/// - Everything else is complete when it arrives.
/// - A complete percept releases those that began before it and still wait, in order of time, as they are then: the
///   human has gone on. But a pointing that waits is kept for speech that takes it, speech that waits is not released
///   by pointing, and a percept that is a pointing sample releases nothing.
/// - Percepts are released in the order of their completion; at one time in order of their beginnings, then gestures
///   that point, speech, everything else, then serial.
/// - Fixations of a hand while a gesture of that hand points are that pointing, not another one.
class Fusion {
 public:
  /// `area`: see PointingTrack.
  Fusion(FusionWindow window, Box area) : window_(window), track_(area) {}

  /// How long after its time an event may arrive and still count: as long as a pointing can precede its words.
  double latest_s() const { return std::max(window_.before_s, window_.lateness_s); }

  /// A percept arrived at `now`. False, and nothing changes, if that is more than latest_s() after its time. `now`
  /// never decreases. All arrivals of one time are received before `release` of that time.
  bool receive(Percept percept, SimTime now);

  /// A sample of where a hand points arrived at `now`. It never waits. False under the condition of `receive`.
  bool sample(const InputEvent& event, int serial, SimTime now);

  /// The ensembles that are complete at `now`, in order.
  std::vector<Ensemble> release(SimTime now);

  /// All that waits, in order, as it is now.
  std::vector<Ensemble> release_all();

  /// Whether an input up to this serial waits.
  bool waits(int serial) const;

  /// From now on with this window.
  void use(FusionWindow window) { window_ = window; }

  /// The latest time at which a waiting percept will be complete if nothing more arrives; nullopt if none waits.
  std::optional<SimTime> due() const;

 private:
  struct Sample {
    InputEvent event;
    int serial;
  };
  using Arrival = std::variant<Sample, Percept>;
  /// The waiting percepts: their bindings and their times of completion, as things are.
  struct Plan {
    struct Part {
      std::vector<std::optional<Deixis>> bound;  ///< for each taker
      bool taken = false;                        ///< of a pointing: by speech
      std::optional<SimTime> complete;           ///< none for a percept that is taken
    };
    std::vector<Part> parts;  ///< of each that waits
  };

  SimTime lateness() const { return SimTime::from_seconds(window_.lateness_s); }
  bool is_too_late(SimTime t, SimTime now) const;
  void arrive(Arrival arrival);
  void process_next();
  std::optional<SimTime> next_arrival() const;
  std::optional<SimTime> next_complete() const;
  Plan plan() const;
  std::vector<Deixis> fixations() const;
  bool release_first(std::vector<Ensemble>& released);
  void release_up_to(std::size_t last, const std::vector<Plan::Part>& parts, std::vector<Ensemble>& released);
  void take(const Deixis& pointing);
  void forget();

  FusionWindow window_;
  PointingTrack track_;
  std::vector<Arrival> arrived_;                           // their turn is yet to come; in order of time
  std::vector<Percept> waiting_;                           // not after now_, in order of time
  std::vector<Deixis> released_;                           // pointings of late that were released alone
  std::vector<Deixis> gestures_;                           // recent ones, released, taken or waiting
  SimTime now_{std::numeric_limits<std::int64_t>::min()};  // up to here, in the time of events, everything was done
};

}  // namespace continua
