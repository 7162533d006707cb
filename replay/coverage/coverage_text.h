// Coverage for people and for programs.
#pragma once

#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/replay/coverage/coverage.h"

namespace continua {

/// 0 … 100, rounded down: 100 is all. With nothing to reach, 100.
std::size_t percent(std::size_t reached, std::size_t of);

/// For each machine a table of its kinds, with counts, per cent and bars, and the parts never reached: of each kind the
/// first dozen, or all. "in all" is the machine's own.
std::string coverage_text(const std::vector<MachineCoverage>& machines, bool all_never_reached);

/// {"machines": [{"name", "digest", "lexicon" {"name", "digest"} or null, "runs", "reached", "of", "kinds": [{"kind",
/// "reached", "of", "items": [{"name", "outcome", "what", "count"}]}]}]}; empty fields are left out.
Json coverage_json(const std::vector<MachineCoverage>& machines);

}  // namespace continua
