// Annotations as ELAN and Praat have them: tiers of labelled stretches of time, which neither overlap nor are empty.
// Readers and writers of files go from and to this; so do traces and runs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/sim_time.h"

namespace continua {

struct Annotation {
  std::size_t n = 0;  ///< the record, or the line of the trace, that it tells of; read: the line of the file, or 0
  std::int64_t begin_ms = 0, end_ms = 0;
  std::string value;
  /// The whole event of a trace that it stands for, with its place: {"line", "at": [begin, end], "event"}. Null: none.
  Json event = {};
};

struct Tier {
  std::string name;
  std::string participant = {};  ///< "human", "avatar", or empty
  std::vector<Annotation> annotations = {};
};

/// A recording that the annotations are about.
struct Media {
  std::string file;
  double offset_s = 0;  ///< time of the recording when that of the annotations is 0
};

struct Annotations {
  std::string name;      ///< the file's path as given
  std::string recorded;  ///< when, as a trace's header tells it; empty if it is not known
  std::string header;    ///< the first line of the trace; empty: it was annotated by hand
  std::vector<Media> media;
  std::vector<Tier> tiers;
  std::int64_t end_ms = 0;
};

/// Ending of the name of the tier with the events of another tier. ELAN has it below that tier.
inline constexpr const char* events_ending = ": event";

/// Whole milliseconds, as annotations have them.
std::int64_t milliseconds(SimTime t);

/// The text without control characters, which neither XML nor Praat can hold, and without blanks at its ends.
std::string label_of(std::string_view text);

/// Tiers in the making: events come in any order, the annotations have one.
class TierMaker {
 public:
  /// The stretch that an annotation is to have. Without `until` it is `shown` long, which is told to nobody but the
  /// eye.
  struct Stretch {
    SimTime from{};
    std::optional<SimTime> until = {};
    SimTime shown{};
  };

  /// Adds an annotation to the tier of this name; tiers keep the order in which they got their first. `event` as of a
  /// trace, or null.
  void add(const std::string& tier, std::size_t n, const Stretch& stretch, std::string value, Json event = {},
           std::size_t line = 0);

  /// The end of the last annotation added to a tier, which may not be known before something else happens.
  void end_last(const std::string& tier, SimTime until);

  /// The tiers. An annotation ends where the next one begins. Where two begin in one millisecond, they are one
  /// annotation; where one of them stands for an event, the later one begins in the next millisecond.
  std::vector<Tier> finish();

 private:
  struct Entry {
    std::size_t n = 0, line = 0;
    Stretch stretch;
    std::string value;
    Json event;
  };
  struct Row {
    std::string name;
    std::vector<Entry> entries;
  };
  Row& row(const std::string& name);
  static std::vector<Annotation> laid_out(std::vector<Entry> entries);

  std::vector<Row> rows_;
};

}  // namespace continua
