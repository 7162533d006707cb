// A difference of two runs for people and programs: as text, as Markdown for a pull request, as JSON.
#pragma once

#include <string>

#include "continua/core/located_json.h"
#include "continua/replay/diff/run_diff.h"

namespace continua {

struct DiffTextOptions {
  bool colour = false;
  std::size_t most = 10;  ///< differences shown besides the first
};

/// The sentence first; then the way there, the first difference, the values, the consequences, and where the runs meet
/// again.
std::string diff_text(const RunIndex& a, const RunIndex& b, const RunDiff& diff, const DiffTextOptions& options = {});

/// The same with the details folded.
std::string diff_markdown(const RunIndex& a, const RunIndex& b, const RunDiff& diff);

/// {"same", "sameness", "sentence", "cause" {"kind", "what", "a", "b", "sentence"}, "evidence" [], "first", "led"
/// {"a" [], "b" []}, "differences" [{"kind", "t", "a" [], "b" [], "change"}], "count", "meet" {"a", "b"} or null,
/// "givens" [{"kind", "what", "a", "b", "sentence"}], "inputs" {"a", "b", "common"}, "farthest", "largest_distance_m"}.
/// Records are
/// {"n", "t", "kind", "brief"}; `first` is the place in `differences` of the one that the cause is of.
Json diff_json(const RunIndex& a, const RunIndex& b, const RunDiff& diff);

}  // namespace continua
