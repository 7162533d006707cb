// Events of traces as annotations: the tier of each, and its label, which people read and write.
#pragma once

#include <string>

#include "continua/replay/annotation/annotations.h"

namespace continua {

/// The tier of an event, given as a trace has it: "human speech", "observed action", else the name of its kind.
std::string tier_of_event(const Json& event);

/// The label of an event: the words of speech, "right point left start 0.1,-0.2" of a gesture (hand, name, direction,
/// phase and target, as far as they are known), "right 0.1,-0.2" of a sample.
std::string label_of_event(const Json& event);

/// Adds events of a trace to tiers, each with its label, its words and all that gives it back.
class EventTiers {
 public:
  explicit EventTiers(TierMaker& tiers) : tiers_(tiers) {}

  /// `event` as a trace has it, on `line` of it; `n` is the record that tells of it, or the line.
  void add(std::size_t n, std::size_t line, const Json& event);

 private:
  TierMaker& tiers_;
  std::string begun_;  // hand and name of the last gesture, if it has begun and not stopped
};

}  // namespace continua
