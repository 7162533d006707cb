// Where two runs part, why, the consequences, and where they meet again. Reads run logs alone: of different traces,
// machines, lexicons, worlds and programs alike.
//
// Inputs are aligned first (event_changes.h). The records that followed from an input in one run are then compared with
// those of its counterpart by their content (run_meaning.h), without running numbers, ids and times.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/core/sim_time.h"
#include "continua/replay/diff/event_changes.h"
#include "continua/replay/diff/run_givens.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// Part of the runs that is not the same.
struct RunDifference {
  enum class Kind {
    input,     ///< an event of the trace was dropped, added, moved, changed or swapped with another
    happened,  ///< something else followed from the same input
    decided,   ///< the same happened, decided by other numbers, parses or candidates
    timing,    ///< the same at another time
    outcome,   ///< an act came to something else
    poses,     ///< bodies are elsewhere
  };
  Kind kind = Kind::happened;
  std::vector<std::size_t> a, b;     ///< records of each run, in order; none where it has nothing there
  std::optional<EventChange> input;  ///< under `input`; places are those of records
  SimTime t;                         ///< of the first of them
};

/// "input", …
const char* name_of(RunDifference::Kind kind);

/// Why the runs part.
struct RootCause {
  /// "input", "condition value", "machine", "phrases", "lexicon", "gestures", "raising", "voxemes", "scene", "learned",
  /// "choice", "world", "perspective", "program", "timing only", "physics only", "cut short" (a log), "none"
  std::string kind = "none";
  std::string what;      ///< the part of it: "transition 'ask': when", "the plate", "seed"; empty where kind says all
  Json a, b;             ///< the thing in each run; null: not there
  std::string sentence;  ///< without its kind, beginning with a small letter, no full stop
};

struct RunDiff {
  enum class Sameness {
    same,
    without_effect,  ///< made of different parts, and all the same
    different,
    unrelated,  ///< too little in common for a comparison
  };
  Sameness sameness = Sameness::same;
  std::string sentence;  ///< all of it in one: where they part, on what grounds, and why
  RootCause cause;
  std::vector<std::string> evidence;  ///< the values that speak for the cause, a sentence each
  std::vector<GivenDifference> givens;
  std::vector<RunDifference> differences;  ///< in order of time, the first `most_differences`
  std::size_t count = 0;                   ///< of all of them
  std::size_t first = 0;                   ///< place in `differences` of the one that the cause is of
  std::vector<std::size_t> led_a, led_b;   ///< causes of its first record in each run, the earliest first
  /// Records of both in which they are in the same state with the same stack again, after the first difference.
  std::optional<std::pair<std::size_t, std::size_t>> meet;
  /// Records of both with the same content, or with the same input as their cause: growing in both. Of very many some,
  /// at even distances, at most about twice `most_pairs`.
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  std::size_t inputs_a = 0, inputs_b = 0, inputs_common = 0;
  std::string farthest;           ///< the body that is farthest from where it is in the other run
  double largest_distance_m = 0;  ///< of a body in one run from where it is in the other; with the same decisions only
};

/// "same", "without effect", "different", "unrelated"
const char* name_of(RunDiff::Sameness sameness);

/// Whether nothing that happened differs.
bool is_same(const RunDiff& diff);

struct DiffOptions {
  double tolerance_m = 1e-3;  ///< bodies that are nearer than this to where they are in the other run are there too
};

inline constexpr std::size_t most_differences = 1000, most_pairs = 4000;

/// The error is of a record that cannot be read.
Result<RunDiff> diff_runs(const RunIndex& a, const RunIndex& b, const DiffOptions& options = {});

}  // namespace continua
