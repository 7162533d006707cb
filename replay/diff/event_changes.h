// The events of one trace against those of another: the same ones, those that came earlier or later, and those that
// were changed, left out or added.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "continua/core/sim_time.h"

namespace continua {

/// An event as far as it counts for being told apart.
struct EventSeen {
  std::uint64_t content = 0;   ///< equal for events that say the same, whenever they do
  std::uint64_t modality = 0;  ///< equal for those of one kind: only such can have become one another
  SimTime t;
};

struct EventChange {
  enum class Kind {
    dropped,  ///< only in a
    added,    ///< only in b
    moved,    ///< the same at another time, or in another order
    changed,  ///< at its place another of the same kind
    swapped,  ///< with `other`: each stands where the other stood
  };
  Kind kind = Kind::changed;
  std::optional<std::size_t> a, b;                                ///< the event, by its place in both
  std::optional<std::pair<std::size_t, std::size_t>> other = {};  ///< under `swapped`: places of the second event
};

/// "dropped", …
const char* name_of(EventChange::Kind kind);

struct EventAlignment {
  /// Events that are the same or became one another, by a's places. With dropped and added ones they are all.
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::vector<EventChange> changes;  ///< in order of time
  std::size_t same = 0;              ///< pairs of equal content
};

/// Events by content and time first, then by content alone, then by their kind between those. Both in order of t.
EventAlignment align_events(const std::vector<EventSeen>& a, const std::vector<EventSeen>& b);

}  // namespace continua
