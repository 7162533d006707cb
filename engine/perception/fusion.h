// Which pointing goes with which word (semantics §3, Ensembles). What comes out depends on when things happened, not on
// the order in which they were told: arrivals that are out of order within `lateness` are put in order first.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "perception/deixis.h"
#include "perception/input_event.h"

namespace continua {

/// A machine states it in its file; all in seconds. A pointing goes with a word if it ends at most `before` before the
/// word begins and begins at most `after` after the word ends.
struct FusionWindow {
  double before_s = 2;
  double after_s = 1;
  double lateness_s = 0;  ///< how long after its event time an event may still arrive; 0: sources tell in order
};

/// A part of an utterance that pointing can give content to: a demonstrative, or a noun phrase around one.
struct Taker {
  SimTime from, until;  ///< of its words
  bool needs = false;   ///< it says nothing without: here, this one. Else pointing only helps: the cup
};

/// Something that happened, as it waits to be understood.
struct Percept {
  int serial = 0;  ///< of its input
  InputEvent event;
  std::optional<Deixis> deixis;  ///< of a gesture that points
  std::vector<Taker> takers;     ///< of speech
};

/// What is understood at once: a percept with the pointings that go with it.
struct Ensemble {
  Percept percept;
  std::vector<std::optional<Deixis>> bound;  ///< one for each taker
  SimTime at;                                ///< when it was complete
};

/// Assigns pointings to takers: each to one at most, in their order (a taker that comes later gets a later pointing),
/// those that need one first, then by the smallest total distance in time; within the window. Gestures before
/// fixations of the samples.
std::vector<std::optional<Deixis>> bind(const std::vector<Taker>& takers, const std::vector<Deixis>& pointings,
                                        const FusionWindow& window);

/// What waits for its counterpart: a value.
///
/// - Speech all of whose needing takers have a pointing is complete; other speech waits until no pointing can come any
///   more (`after` past the end of its last needing taker), and is then released without.
/// - A gesture that points waits for speech that takes it until `after` past its end, and is released alone then. When
///   speech takes it, it is not released at all; a pointing that was released alone can still be taken within `before`.
/// - Everything else is complete when it arrives.
/// - What is complete releases what began before it and still waits, in order of time, as it is then: the human has
///   gone on. But a pointing that waits is kept for speech that takes it, and speech that waits is not released by
///   pointing.
/// - Released in order of time; at one time in the order: gestures that point, speech, everything else, then serial.
class Fusion {
 public:
  /// `area`: see PointingTrack.
  Fusion(FusionWindow window, Box area) : window_(window), track_(area) {}

  /// A percept arrived at `now`. False, and nothing changes, if it is later than `lateness` allows: what comes after it
  /// has been released already. `now` never decreases.
  bool receive(Percept percept, SimTime now);

  /// A sample of where a hand points. It never waits.
  void sample(const InputEvent& event, int serial);

  /// What is complete at `now`, in order.
  std::vector<Ensemble> release(SimTime now);

  /// When something that waits will be complete at the latest; nothing waits if there is none.
  std::optional<SimTime> due() const;

 private:
  FusionWindow window_;
  PointingTrack track_;
  std::vector<Percept> waiting_;  // in order of time
  std::vector<Deixis> released_;  // pointings of late that were released alone
  SimTime released_until_;
};

}  // namespace continua
