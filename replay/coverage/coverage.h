// The parts of their machines that a set of runs reached, counted from run logs alone: states, transitions, both
// outcomes of conditions and gates, operations, phrases, and the knowledge that they used. The reachable parts of a
// machine are in each log's header; those of the knowledge have to be added (add_reachable).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// Something that a run can reach.
struct CoverageItem {
  std::string name;     ///< a state, a transition, an operation, a phrase, a rule, the words of an entry
  std::string outcome;  ///< of a condition or a gate: which of the two; else empty
  std::string what;     ///< the condition; of an entry its category and term; else empty
  std::size_t count = 0;
};

/// Things of one kind, in the order of the machine's file; of the knowledge, by name.
struct CoverageKind {
  std::string name;
  std::vector<CoverageItem> items = {};
  bool of_knowledge = false;  ///< not the machine's own

  std::size_t reached() const;
};

inline constexpr const char* raising_rules = "raising rules";
inline constexpr const char* lexicon_rules = "lexicon rules";
inline constexpr const char* lexicon_entries = "lexicon entries";

/// A sense of words, not yet counted; without a category: that the words may be passed over.
CoverageItem lexicon_entry(const std::string& words, const std::string& category, const std::string& term);

/// The parts that runs of one machine reached.
struct MachineCoverage {
  std::string name, digest;
  std::string lexicon, lexicon_digest;  ///< empty: the machine has none
  std::size_t runs = 0;
  /// "states", a run's first one included; "transitions"; "conditions" of transitions, `held` or `did not hold`;
  /// "gates" of states, `passed` or `turned away`; "operations" of transitions and gates; "phrases", case by case;
  /// raising_rules, lexicon_rules and lexicon_entries, of which only those that were used.
  std::vector<CoverageKind> kinds;

  CoverageKind& kind(const std::string& name);
  /// Counts the machine's own parts only: knowledge is there for all machines.
  std::size_t reached() const;
  std::size_t reachable() const;
};

/// Coverage of one run. An error if its log has no graph. Parts that the graph does not name are not counted.
Result<MachineCoverage> coverage_of(const RunIndex& run);

/// Adds the counts of runs of the same machine. Parts that only `more` has come last.
void add(MachineCoverage& sum, const MachineCoverage& more);

/// Coverages of the same machines as one, the machines in the order in which they first come. Runs of a machine whose
/// file or lexicon was another are apart.
std::vector<MachineCoverage> by_machine(const std::vector<MachineCoverage>& runs);

/// The reachable parts of a kind: those that no run reached are added with a count of 0, and all are in this order;
/// parts that are not among them come last.
void add_reachable(CoverageKind& kind, const std::vector<CoverageItem>& all);

}  // namespace continua
