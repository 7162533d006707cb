// A run cut into the human's inputs and the answers to them: the answer observed when the trace was made, and the
// present one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/core/sim_time.h"
#include "continua/replay/score/agreement.h"

namespace continua {

/// An input of the human, and the deeds after it.
struct Episode {
  SimTime t;
  int n = 0;             ///< record of the input
  std::size_t line = 0;  ///< of the trace
  std::string symbol;    ///< the input as machines know it
  bool sample = false;   ///< one of a pointing hand's samples
  std::vector<AvatarMove> observed, produced;
  AgreementLevel level = AgreementLevel::exact;
};

/// Gathers the episodes of a run, in order. A move belongs to the latest input. Samples come all the time: only a move
/// of its very instant belongs to a sample, and only from an avatar that answers at once. Otherwise that is chance, or
/// the sample ended the wait of the words before it. Before any other input, moves belong to the latest sample.
class Episodes {
 public:
  /// `at_once`: whether whoever was observed answers inputs at their instants. `all`: whether those that are over are
  /// kept; a run of days need not hold them.
  Episodes(bool at_once, bool all) : at_once_(at_once), keeps_all_(all) {}

  /// A new one begins.
  void begin(Episode episode) {
    if (!keeps_all_) forget();
    if (!episode.sample) latest_ = all_.size();
    all_.push_back(std::move(episode));
  }
  void observed(AvatarMove move, SimTime t) { of(t).observed.push_back(std::move(move)); }
  void produced(AvatarMove move, SimTime t) { of(t).produced.push_back(std::move(move)); }

  /// The one that moves belong to once the instant of the last input is over; nullptr before the first.
  const Episode* open() const { return all_.empty() ? nullptr : latest_ ? &all_[*latest_] : &all_.back(); }
  /// The one that began last; nullptr before the first.
  const Episode* last() const { return all_.empty() ? nullptr : &all_.back(); }
  /// The episodes that were kept, compared with the observed answers; deeds before any input are no episode.
  std::vector<Episode> take(const Blanks& blanks) {
    for (auto& episode : all_) episode.level = agreement(episode.observed, episode.produced, blanks);
    return std::move(all_);
  }

 private:
  // Only the latest that is no sample can still get moves when another begins.
  void forget() {
    std::vector<Episode> open;
    if (latest_) open.push_back(std::move(all_[*latest_]));
    all_ = std::move(open);
    if (latest_) latest_ = 0;
  }

  Episode& of(SimTime t) {
    if (all_.empty()) return before_;
    if (!latest_ || (at_once_ && all_.back().t == t)) return all_.back();
    return all_[*latest_];
  }

  bool at_once_, keeps_all_;
  std::vector<Episode> all_;
  std::optional<std::size_t> latest_;  ///< that is no sample
  Episode before_;
};

}  // namespace continua
