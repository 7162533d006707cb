// Looks for conversations that go wrong: makes them of the lexicon's examples and the machine's arcs, keeps those that
// reach something new, and goes on from these.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/session/session.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// A fault of a run. Two with the same kind and place are the same fault.
struct Fault {
  /// "problem": one is reported; "refusals": three inputs of words or gestures in a row have no effect at all; "dead":
  /// so have all that follow, whatever they are; "wordless": an act without a word from the human's move to the next;
  /// "worlds": the acts are others with physics.
  std::string kind;
  std::string place;  ///< the problem's sentence without numbers, the state, the act's program
  auto operator<=>(const Fault&) const = default;
};

/// Findings of the first three kinds and "wordless", in the order of the log.
std::vector<Fault> faults_of(std::string_view log);

/// The transitions of a run, and pairs of them that follow each other.
std::vector<std::string> reached_in(std::string_view log);

/// The inputs that a search combines: utterances of the lexicon's examples, inputs that arcs of the machine name,
/// gestures of the catalogue, pointing at objects of the scene. Times are 0.
Result<std::vector<TraceEvent>> turns_for(Session& session);

struct SearchFinding {
  Fault fault;
  Trace trace;  ///< shrunk: without any event the fault is another or none
};

struct SearchOptions {
  std::uint64_t seed = 0;
  int longest = 12;                                ///< turns of a conversation
  bool guided = true;                              ///< by what is reached; otherwise each conversation is drawn anew
  std::function<bool()> enough;                    ///< asked before each run
  std::function<void(const SearchFinding&)> tell;  ///< of each, at once
};

struct SearchSummary {
  std::size_t runs = 0, kept = 0, reached = 0;  ///< conversations that reached something new; things reached
  std::vector<SearchFinding> findings;
};

/// `physics`: the same scene and machine in the physical world; null: worlds are not compared. Deterministic but for
/// `enough`.
Result<SearchSummary> search_traces(Session& kinematic, Session* physics, const SearchOptions& options);

}  // namespace continua
