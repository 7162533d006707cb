// A state graph to be drawn: the common form of a machine's picture and a run's.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"

namespace continua {

/// All texts are one line: control characters are replaced by their pictures (␊).
struct StateGraph {
  struct State {
    std::string name;
    bool accepting = false;
    std::string gate;                   ///< condition tested on entry; empty: none
    std::optional<std::size_t> visits;  ///< how often a run entered it; nullopt: no run
  };
  struct Edge {
    std::optional<std::size_t> from;  ///< nullopt: every state
    std::size_t to = 0;
    std::string id;         ///< of the transition; empty for a gate's rejection
    std::string input;      ///< empty for a gate's rejection
    bool epsilon = false;   ///< consumes no input
    bool rejected = false;  ///< leads to the state for inputs that the gate of `from` does not let in
    std::string condition;  ///< empty: always
    std::string operation;  ///< with its content; empty: none
    double weight = 1;
    std::optional<std::size_t> visits;  ///< how often a run took it; nullopt: no run
  };

  std::string name;
  std::optional<std::size_t> start = 0;  ///< REQUIRES less than states.size() to be drawn; nullopt: not among them
  std::vector<State> states;
  std::vector<Edge> edges;
};

/// From the `graph` of a run log's header (RUNLOG.md), with `visits` where it has them (run_views.h, run_graph). A
/// transition from all states of more than a few becomes one edge.
Result<StateGraph> state_graph_of(const Json& graph, const std::string& name);

/// The machine of a run, with the run's visits.
Result<StateGraph> state_graph_of(const RunIndex& run);

/// One arrow of the drawing: all edges that lead from one state to another. Loops that consume an input, loops that do
/// not, and rejections are arrows of their own.
struct Arrow {
  std::optional<std::size_t> from;  ///< nullopt: every state
  std::size_t to = 0;
  bool epsilon = false;  ///< of a loop: consumes no input
  bool rejected = false;
  std::vector<std::string> lines;   ///< one for each edge, as short as a label of dot text must be
  std::vector<std::string> labels;  ///< the same at full length
  std::vector<std::string> full;    ///< with the transition's id before
  std::optional<std::size_t> visits;

  bool loops() const { return from == to; }
};

/// In the order of their first edges.
std::vector<Arrow> arrows_of(const StateGraph& graph);

/// A state in full: its name, gate and visits.
std::string description(const StateGraph::State& state);

/// How wide a text is, in characters of a font whose characters are all of one width.
std::size_t columns(std::string_view text);

}  // namespace continua
