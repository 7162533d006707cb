// How tiers of a corpus become events of a trace: the file of `import --tiers` (TIERS.md).
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/annotation/annotations.h"

namespace continua {

/// How the annotations of one tier are used.
struct TierUse {
  std::string kind;     ///< a kind of event; empty: they are left out
  std::string channel;  ///< of `observed`
  /// The parts of a gesture's label, in their order: "hand", "name", "direction", "phase", "target".
  std::vector<std::string> parts = {"hand", "name", "direction", "phase", "target"};
  bool phases = false;           ///< a gesture is two events: it starts, and it stops
  Json values = Json::object();  ///< {label: the label to read in its place}
  Json set = Json::object();     ///< further members of every event
};

struct TierMap {
  Json header = Json::object();  ///< members of the trace's header
  std::vector<std::pair<std::string, TierUse>> tiers;
};

/// The words by which tiers of unknown corpora are guessed.
struct TierNames {
  std::vector<std::string> avatar;                                         ///< the other agent's
  std::vector<std::pair<std::string, std::vector<std::string>>> of_kinds;  ///< the first kind that has a word counts
};

/// Everything that is wrong with a map.
std::vector<Error> tier_map_problems(std::string_view text, const std::string& name);
Result<TierMap> parse_tier_map(std::string_view text, const std::string& name);

std::vector<Error> tier_names_problems(std::string_view text, const std::string& name);
Result<TierNames> parse_tier_names(std::string_view text, const std::string& name);

/// The map for a file: the tiers that an export makes, by their names; others by the words in theirs. The other agent's
/// tiers are observed. A tier that no word tells is left out.
TierMap guessed_map(const Annotations& annotations, const TierNames& names);

/// The map as a file, for people to change.
std::string print(const TierMap& map);

}  // namespace continua
