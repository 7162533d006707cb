// A run cut into what the human did and what came of it: what was observed to come of it when the trace was made, and
// what came of it now.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/core/sim_time.h"
#include "continua/replay/score/agreement.h"

namespace continua {

/// An input of the human, and what was done after it.
struct Episode {
  SimTime t;
  int n = 0;             ///< record of the input
  std::size_t line = 0;  ///< of the trace
  std::string symbol;    ///< the input as machines know it
  bool sample = false;   ///< one of a pointing hand's samples
  std::vector<AvatarMove> observed, produced;
  AgreementLevel level = AgreementLevel::exact;
};

/// Gathers the episodes of a run, in order. A move belongs to the input that came last. Samples come all the time: to
/// one belongs only what is of its instant, and only of those who answer at once. Of others that is chance, or the
/// sample ended what the words before it waited for. Before any other input, moves belong to the sample that came last.
class Episodes {
 public:
  /// `at_once`: whether whoever was observed answers inputs at their instants.
  explicit Episodes(bool at_once) : at_once_(at_once) {}

  /// A new one begins.
  void begin(Episode episode) {
    if (!episode.sample) latest_ = all_.size();
    all_.push_back(std::move(episode));
  }
  void observed(AvatarMove move, SimTime t) { of(t).observed.push_back(std::move(move)); }
  void produced(AvatarMove move, SimTime t) { of(t).produced.push_back(std::move(move)); }

  /// The one that moves belong to once the instant of the last input is over; nullptr before the first.
  const Episode* open() const { return all_.empty() ? nullptr : latest_ ? &all_[*latest_] : &all_.back(); }
  /// The one that began last; nullptr before the first.
  const Episode* last() const { return all_.empty() ? nullptr : &all_.back(); }
  /// All, held against what was observed; what was done before anything was put in is no episode.
  std::vector<Episode> take(const Blanks& blanks) {
    for (auto& episode : all_) episode.level = agreement(episode.observed, episode.produced, blanks);
    return std::move(all_);
  }

 private:
  Episode& of(SimTime t) {
    if (all_.empty()) return before_;
    if (!latest_ || (at_once_ && all_.back().t == t)) return all_.back();
    return all_[*latest_];
  }

  bool at_once_;
  std::vector<Episode> all_;
  std::optional<std::size_t> latest_;  ///< that is no sample
  Episode before_;
};

}  // namespace continua
