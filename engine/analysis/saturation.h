// All configurations that a pushdown system can reach while it reads a word, as a finite automaton of their stacks,
// saturated letter by letter (post*; sources in analysis/acceptance.h).
//
// An edge (control, symbol, rest) of the present layer stands for the configurations in that control with that symbol
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

  /// Adds the configurations that ε-rules reach now, and the rules of `free_letters`, which may come at any time and
  /// in any number.
  void close(const std::vector<int>& free_letters = {});
  /// Reads one letter: the next layer has the configurations that its rules lead to.
  void read(int letter);

  /// In the order in which they were reached.
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
  std::size_t closed_ = 0;  ///< so many edges are saturated

  struct Node {
    std::vector<std::pair<int, int>> edges;  ///< symbol, rest
    std::vector<int> popped_to;              ///< controls of the layer that came down to it
  };
  std::vector<Node> nodes_;
  std::map<std::vector<int>, int> node_of_;                ///< of the layer: control, pushed symbols
  std::unordered_set<Edge, HashEdge> known_below_, pops_;  ///< of the layer
  std::vector<int> visited_;                               ///< nodes whose `popped_to` is of the layer
};

}  // namespace continua
