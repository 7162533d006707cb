// Binds pointings to words (SEMANTICS.md §3, Ensembles). The result depends on when events happened, not on the order
// of their arrival: arrivals within `lateness` are put in order first. Later arrivals are matched by their own time
// with the percepts that still wait; ensembles that were complete before stay as they were.
#pragma once

#include <algorithm>
#include <functional>
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

/// A move of an utterance: the number of the recogniser's alternative, and of the move in it.
struct MovePlace {
  std::size_t alternative = 0;
  std::size_t fragment = 0;
};

/// An event that waits to be understood.
struct Percept {
  int serial = 0;  ///< of its input
  InputEvent event;
  std::optional<Deixis> deixis;                        ///< of a gesture that points
  std::vector<Taker> takers;                           ///< of speech
  std::shared_ptr<const Readings> readings = nullptr;  ///< of speech, if the machine has a lexicon
  bool unfinished = false;                             ///< of speech: its sentence may go on
  SimTime spoken = {};                                 ///< of speech: the end of its words
  std::vector<int> pieces = {};                        ///< serials of earlier inputs whose words it goes on with
  bool before_words = false;                           ///< of a gesture: shown during words, it comes before them
  int again = 0;  ///< how many times more its move under way is attended to, in the states that it led to before
  std::optional<MovePlace> resumes = {};  ///< of one that is attended to again: the move to go on from
  std::vector<int> assured = {};  ///< serials of the inputs that made an unsure one sure; empty: it was not asked about
};

/// Makes one percept of two pieces of a sentence; none if they do not read as one.
using Joining = std::function<std::optional<Percept>(const Percept& first, const Percept& second)>;

/// A percept with its pointings, complete and ready to be understood.
struct Ensemble {
  Percept percept;
  std::vector<std::optional<Deixis>> bound;  ///< one for each taker
  SimTime at;                                ///< the time at which it was complete, in the time of events
};

/// The percepts that wait for their counterparts: a value.
///
/// - An utterance is complete when every taker that needs a pointing has one and the last such taker has been spoken
///   (perception/speech_times.h): until then a better pointing may come. A fixation counts from settled_at() on.
/// - An utterance that lacks a pointing, or has one that was made with other words of it, waits until none can come any
///   more, `after` past the end of its last needing taker, and is then released as it is.
/// - A pointing gesture waits until `after` past its end for speech that takes it, and is then released alone. It is
/// not
///   released if speech takes it. Speech can still take it within `before` after it was released alone.
/// - An unfinished sentence also waits for its next piece, until `pause` past its end, or past the pointing that goes
///   with its last words. Words that begin until then are joined with it, and the whole may be unfinished again.
/// - Words are not complete before their told end. A gesture that begins during words waits for that end too; it comes
///   after the words, or before them if they still lack a pointing or the gesture says how they are meant
///   (Percept::before_words).
/// - A gesture waits `together`, or for its told end, for words that begin meanwhile, and is released with them:
///   after them, unless they still lack a pointing or the gesture says how they are meant (perception/shown_with.h).
/// - A pointing that no words take is released with the words that it was made with, if these ask for no pointing.
/// - Every other percept is complete when it arrives.
/// - A complete percept also releases the waiting percepts that began before it, in order of time, as they are: the
///   human has gone on. Exceptions: a waiting pointing stays if speech takes it, waiting speech is not released by a
///   pointing, and a pointing sample releases nothing.
/// - Percepts are released in the order in which they were complete. Ties go by beginning; then pointing gestures come
///   first, speech second, all others last; then by serial.
/// - Fixations of a hand during a pointing gesture of that hand belong to that gesture. If its beginning alone is told,
///   they tell its place.
class Fusion {
 public:
  /// `area`: see PointingTrack.
  Fusion(FusionWindow window, Box area) : window_(window), track_(area) {}

  /// The longest time after which an event may arrive and still count: at least as long as a pointing can precede its
  /// words.
  double latest_s() const { return std::max(window_.before_s, window_.lateness_s); }

  /// Receives a percept that arrived at `now`. Returns false, without a change, if that is more than latest_s() after
  /// its time. `now` never decreases. All arrivals of one time are received before release() of that time.
  bool receive(Percept percept, SimTime now);

  /// Receives a pointing sample that arrived at `now`. A sample never waits. Returns false as receive() does.
  bool sample(const InputEvent& event, int serial, SimTime now);

  /// Releases the ensembles that are complete at `now`, in order. Without `joining` all sentences stay apart.
  std::vector<Ensemble> release(SimTime now, const Joining& joining = {});

  /// Releases all waiting percepts, in order, as they are.
  std::vector<Ensemble> release_all(const Joining& joining = {});

  /// Whether an input up to this serial waits.
  bool waits(int serial) const;

  /// Uses this window from now on.
  void use(FusionWindow window) { window_ = window; }

  /// The latest time at which a waiting percept will be complete if nothing more arrives; none if nothing waits.
  std::optional<SimTime> due() const;

 private:
  struct Sample {
    InputEvent event;
    int serial;
  };
  using Arrival = std::variant<Sample, Percept>;
  /// The present bindings of the waiting percepts, and the times at which they are complete.
  struct Plan {
    struct Part {
      std::vector<std::optional<Deixis>> bound;  ///< for each taker
      bool taken = false;                        ///< for a pointing: speech takes it
      std::optional<SimTime> complete;           ///< none if taken
    };
    std::vector<Part> parts;  ///< one for each waiting percept
  };

  SimTime lateness() const { return SimTime::from_seconds(window_.lateness_s); }
  bool is_too_late(SimTime t, SimTime now) const;
  void arrive(Arrival arrival);
  void process_next(const Joining& joining);
  Percept joined(Percept speech, const Joining& joining);
  std::optional<SimTime> next_arrival() const;
  std::optional<SimTime> next_complete() const;
  Plan plan() const;
  bool is_of_gesture(const Deixis& fixation) const;
  Deixis dwelling(const Deixis& gesture, const std::vector<Deixis>& fixations) const;
  bool release_first(std::vector<Ensemble>& released);
  void release_up_to(std::size_t last, const std::vector<Plan::Part>& parts, std::vector<Ensemble>& released);
  void take(const Deixis& pointing);
  void forget();

  FusionWindow window_;
  PointingTrack track_;
  std::vector<Arrival> arrived_;                           // not processed yet, in order of time
  std::vector<Percept> waiting_;                           // not after now_, in order of time
  std::vector<Deixis> released_;                           // recent pointings that were released alone
  std::vector<Deixis> gestures_;                           // recent pointing gestures: waiting, taken or released
  SimTime now_{std::numeric_limits<std::int64_t>::min()};  // events up to this time are processed
};

}  // namespace continua
