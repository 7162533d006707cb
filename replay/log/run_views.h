// The data behind the inspector's panels, worked out from a run's index. Pure: a log in, JSON out.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// Which records are asked for. Times in seconds, both ends included.
struct RecordFilter {
  std::vector<std::string> kinds;  ///< empty: all
  std::optional<double> from_s, to_s;
  std::size_t after = 0;  ///< first n that may be given
  std::size_t limit = 500;
};

/// JSON {records: […], next: n to go on `after`, or null}; each record as it stands in the log.
Result<std::string> run_records(const RunIndex& run, const RecordFilter& filter);

/// The machine's graph with `visits` of each state and edge. Where a gate turned a transition away, an edge is added
/// that says `diverted`.
Result<Json> run_graph(const RunIndex& run);

/// The stack as it stood at record n, top first, and its last change. `change` of a symbol is `added`, `changed` (it
/// took a removed one's place on the same tail) or `same`; `slots_changed` gives {slot: {was, now}}; `told` the words
/// of values that have some; `depth` and `depth_before` count symbols.
Result<Json> run_stack(const RunIndex& run, std::size_t n);

/// Under `explore`: the stack of one of the configurations that the automaton may be in at record n, as the last
/// `branches` record tells, and its difference from that of the branch it comes from; with `branch`, that record's
/// entry for it. The error names the branches. REQUIRES n < run.size().
Result<Json> run_branch_stack(const RunIndex& run, std::size_t n, std::int64_t branch);

/// The same between the stacks as they stood at two records, without `n` and `at`. REQUIRES before, n < run.size().
Result<Json> run_stack_since(const RunIndex& run, std::size_t before, std::size_t n);

/// Why record n: its `chain` of causes, the `applications` behind it with the sub-terms they were built from,
/// and the `inputs` that contributed. REQUIRES n < run.size().
Result<Json> run_derivation(const RunIndex& run, std::size_t n);

}  // namespace continua
