// Which of several pointings goes with which of several words.
#pragma once

#include <optional>
#include <vector>

#include "continua/core/sim_time.h"
#include "continua/perception/deixis.h"

namespace continua {

/// A machine states it in its file; all in seconds. A pointing goes with a word if it ends at most `before` before the
/// word begins and begins at most `after` after the word ends.
struct FusionWindow {
  double before_s = 2;
  double after_s = 1;
  double lateness_s = 0;  ///< how long events wait for earlier ones that come late; 0: sources tell in order
};

/// A part of an utterance that pointing can give content to: a demonstrative, or a noun phrase around one.
struct Taker {
  SimTime from, until;  ///< of its words
  bool needs = false;   ///< it says nothing without: here, this one. Else pointing only helps: the cup
};

/// Assigns pointings to takers: each to one at most, in their order (a taker that comes later gets a later pointing),
/// as many of those that need one as can be, then as many of the others, then by the smallest total distance in time
/// (0 where they overlap); within the window. Where that leaves a choice, gestures before fixations of the samples,
/// then the nearest middles. `takers` are in order of time. For each of them the index of its pointing.
std::vector<std::optional<std::size_t>> assign(const std::vector<Taker>& takers, const std::vector<Deixis>& pointings,
                                               const FusionWindow& window);

}  // namespace continua
