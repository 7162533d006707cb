// All configurations that a pushdown system can reach while it reads a word, as a finite automaton of their stacks,
// saturated letter by letter (post*; sources in analysis/acceptance.h).
//
// An edge (control, symbol, rest) of the present layer represents the configurations in that control with that symbol
// on top of any stack that `rest` spells. Nodes spell stacks by their own edges, down to node 0, the end. A push makes
// edges through the node of (layer, control, pushed symbol), so endless pushing comes back to the same node.
#pragma once

#include <cstdint>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "continua/analysis/pushdown_system.h"

namespace continua {

class Saturation {
 public:
  struct Edge {
    int control = 0, symbol = 0, rest = 0;
    bool operator==(const Edge&) const = default;
  };
  static constexpr int end = 0;

  explicit Saturation(PushdownSystem& system);

  /// Adds the configurations that are reached by ε-rules and by rules of `free_letters`, letters that may come at any
  /// time and in any number.
  void close(const std::vector<int>& free_letters = {});
  /// Reads one letter: the next layer has the configurations that its rules lead to.
  void read(int letter);

  /// Work without end would look like a program that hangs: this counts rules that were applied and edges that were
  /// added, so that the same machine has the same answer everywhere.
  static constexpr std::size_t most_applied = 20'000'000;
  /// The set is not complete, since that would take more than most_applied.
  bool exhausted() const { return applied_ > most_applied; }

  /// The edges of the present layer, in the order in which they were reached.
  const std::vector<Edge>& edges() const { return edges_; }

 private:
  struct HashEdge {
    std::size_t operator()(const Edge& edge) const;
  };

  void apply(const PushdownRule& rule, int rest);
  void add(Edge edge);
  void add_below(int node, int symbol, int rest);
  void pop(int control, int rest);
  int node(std::vector<int> key);

  PushdownSystem& system_;
  std::vector<Edge> edges_;
  std::unordered_set<Edge, HashEdge> known_;
  std::size_t closed_ = 0;  ///< number of saturated edges
  std::size_t applied_ = 0;

  struct Node {
    std::vector<std::pair<int, int>> edges;  ///< symbol, rest
    std::vector<int> popped_to;              ///< controls of the layer that popped down to this node
  };
  std::vector<Node> nodes_;
  std::map<std::vector<int>, int> node_of_;                ///< in the layer: control and pushed symbols → node
  std::unordered_set<Edge, HashEdge> known_below_, pops_;  ///< in the layer
  std::vector<int> visited_;                               ///< nodes with controls of the layer in `popped_to`
};

}  // namespace continua
