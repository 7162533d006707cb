// How well an engine does another avatar's observed deeds: episodes counted. SCORE.md explains the counts.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "continua/replay/score/episodes.h"

namespace continua {

/// Counts of episodes. Samples of a pointing hand come by the hundred, and hardly ever is one answered: those after
/// which nothing was observed are counted apart. The others count like any input.
struct Score {
  int inputs = 0;          ///< episodes that are no samples
  int speaking = 0;        ///< something was observed
  int exact = 0;           ///< of `speaking`, those that agree exactly,
  int lax = 0;             ///< those, and those that agree except for the described places,
  int same_template = 0;   ///< those, and those that agree except for names, attributes, places and gestures
  int answered = 0;        ///< something came out; samples count that are `speaking`
  int spurious = 0;        ///< of `inputs`, something came out where nothing was observed
  int right = 0;           ///< of `inputs`, those that agree at least lax; silence with silence too
  int samples = 0;         ///< samples after which nothing was observed
  int silent_samples = 0;  ///< of those, nothing came out either

  void add(const Episode& episode);
  void add(const Score& other);
  /// The balance of missing and surplus words and acts: 0 … 1. An answer that agrees at least lax is right; an answer
  /// that does not agree is surplus. 1 if nothing was observed and nothing came out.
  double f1() const;
};

/// Whether there is something to look at: an observed answer did not come out, or another one did.
bool is_miss(const Episode& episode);

/// The kind of the observed move: the template of the first action, which tells more than the "OK." before it; without
/// actions of the first words; with gestures alone the first one's head. Empty if nothing was observed.
std::string kind_of(const Episode& episode, const Blanks& blanks);

/// By kind_of; of episodes with an observed answer.
using ScoreOfKinds = std::map<std::string, Score>;

/// A trace's.
struct TraceScore {
  std::string name;   ///< its name in tables
  std::string trace;  ///< its path
  std::string run;    ///< the path of its run log; empty: it was not kept
  Score score;
  ScoreOfKinds kinds;
  std::vector<Episode> misses;  ///< in order of time

  void add(Episode episode, const Blanks& blanks);
};

}  // namespace continua
