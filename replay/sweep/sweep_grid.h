// The points of a sweep: settings of a machine, policies and seeds under which the same traces are replayed (SWEEP.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/located_json.h"

namespace continua {

struct SweepPoint {
  Json set = Json::object();          ///< {name: value}, as --set names them
  std::string policy;                 ///< empty: the machine's
  std::optional<std::uint64_t> seed;  ///< nothing: the traces'

  /// {"set", "policy", "seed"}; the last two only where there are any.
  Json json() const;
};

inline constexpr std::size_t most_sweep_points = 1'000'000;

/// The points that a document with "list", "latin", "grid", "policies" and "seeds" names: each of one with each of the
/// others; the last varies fastest. Names are not compared with a machine's. `name` stands for the document in errors.
Result<std::vector<SweepPoint>> read_sweep_grid(std::string_view text, const std::string& name);

}  // namespace continua
