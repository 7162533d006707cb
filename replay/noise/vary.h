// A trace as noisier recognisers would have told it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "continua/replay/noise/noise.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// An event that went wrong.
struct Edit {
  std::size_t event = 0;            ///< its index in the trace
  std::vector<TraceEvent> becomes;  ///< nothing: it is lost
  std::string sentence;             ///< its change, for people
};

/// The changes of a trace, in the order of its events. The same for the same seed, everywhere. Each event draws for
/// itself, so a stronger noise with the same seed changes what the weaker one changed, and more.
///
/// Confidences: a word has that of a quantile of the table's right words, or of its wrong ones if it was misheard,
/// moved by Bayes' rule from the table's share of wrong words to that of the noise. An utterance is as sure as it is
/// likely that all of its words are right, the product. The readings of an n-best list share 1: the first has that of a
/// word, each further one half of the rest, but not more than the one before.
std::vector<Edit> edits_of(const Trace& trace, const Noise& noise, std::uint64_t seed);

/// The trace with these edits, ascending: its events in order of time, without `expect` lines, numbered anew.
Trace edited_trace(const Trace& trace, const std::vector<Edit>& edits);

}  // namespace continua
