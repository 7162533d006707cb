// Who points where, and from when to when, as a run log (RUNLOG.md) tells it.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/core/sim_time.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/scene/run_points.h"

namespace continua {

/// Somebody points, and where the finger is from when on.
struct RunPointing {
  struct Sample {
    SimTime t{};
    PointedAt at{};
  };
  bool avatar = false;  ///< else the human
  SimTime from{}, until{};
  std::vector<Sample> samples = {};       ///< at least one, in order of time
  std::string hand = {};                  ///< the human's, as the events name it; empty: not known
  std::string on_body = {};               ///< the avatar's: the body it points at, if it is one
  std::vector<std::size_t> records = {};  ///< the events and gestures it was read from, at least one
};

/// Takes a log's inputs and gestures one after the other.
class PointingReader {
 public:
  explicit PointingReader(std::set<std::string> bodies) : bodies_(std::move(bodies)) {}

  /// Record n, an `input`, with the event that it has, as written or read.
  void input(std::size_t n, SimTime t, std::string_view event);
  void input(std::size_t n, SimTime t, const Json& event);
  /// Record n, a `gesture` of the avatar, with its term.
  void avatar_gesture(std::size_t n, SimTime t, const std::string& term);

  /// All of them in order of their beginnings.
  std::vector<RunPointing> finish();

 private:
  std::size_t point(std::size_t n, SimTime t, SimTime until, const std::string& hand, const PointedAt& at);

  std::set<std::string> bodies_;
  std::vector<RunPointing> pointings_;
  std::map<std::string, std::size_t> bursts_, held_;  // hand, hand/gesture → place in pointings_
  std::optional<std::size_t> last_avatar_;            // likewise
};

/// The names of the bodies of the scene in a log's header.
std::set<std::string> bodies_of(const Json& header);

/// Errors: a record cannot be read.
Result<std::vector<RunPointing>> read_pointings(const RunIndex& run);

}  // namespace continua
