// Assigns pointings to words.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "continua/core/sim_time.h"
#include "continua/perception/deixis.h"

namespace continua {

/// The time window of a machine's `fusion`, in seconds. A pointing goes with a word if it ends at most `before` before
/// the word's utterance begins and begins at most `after` after the word ends.
struct FusionWindow {
  double before_s = 2;
  double after_s = 1;
  double lateness_s = 0;  ///< how long events wait for earlier ones that come late; 0: events arrive in order
  double pause_s = 0;     ///< how long an unfinished sentence waits for its next piece; 0: it does not wait
  /// How long a gesture waits for words that it is shown with, and an act that words ask for waits for a gesture that
  /// contradicts them, before it begins; 0: neither waits.
  double together_s = 0;
};

/// A part of an utterance that pointing can give content to: a demonstrative, a definite noun phrase, a noun alone.
struct Taker {
  SimTime from, until;  ///< of its words
  bool needs = false;   ///< means nothing without pointing: here, this one; false: pointing only helps: the cup
  std::optional<SimTime> begun = {};  ///< the beginning of its utterance; none: its own
};

/// The time between the pointing and the words, in µs; 0 if they overlap.
std::int64_t gap_us(const Taker& taker, const Deixis& pointing);

/// Assigns pointings to takers within the window: each pointing to one taker at most, and later pointings to later
/// takers. Criteria, in order: the most needing takers with a pointing; the most other takers with one; the smallest
/// total distance in time (0 if they overlap); gestures before fixations of samples; the nearest middles. `takers` are
/// in order of time. Returns for each taker the index of its pointing.
std::vector<std::optional<std::size_t>> assign(const std::vector<Taker>& takers, const std::vector<Deixis>& pointings,
                                               const FusionWindow& window);

}  // namespace continua
