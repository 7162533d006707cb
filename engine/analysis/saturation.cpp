#include "continua/analysis/saturation.h"

#include <algorithm>

namespace continua {

std::size_t Saturation::HashEdge::operator()(const Edge& edge) const {
  auto hash = static_cast<std::uint64_t>(edge.control);
  for (const int part : {edge.symbol, edge.rest})
    hash = (hash ^ static_cast<std::uint32_t>(part)) * 0x9E3779B97F4A7C15u;
  return static_cast<std::size_t>(hash ^ (hash >> 32));
}

Saturation::Saturation(PushdownSystem& system) : system_(system), nodes_(1) {
  apply({system.initial_control(), system.initial_stack(), {}}, end);
}

void Saturation::close(const std::vector<int>& free_letters) {
  for (; closed_ < edges_.size() && !exhausted(); ++closed_) {
    const Edge edge = edges_[closed_];
    for (const auto& rule : system_.rules(edge.control, edge.symbol, PushdownSystem::epsilon)) apply(rule, edge.rest);
    for (const int letter : free_letters)
      for (const auto& rule : system_.rules(edge.control, edge.symbol, letter)) apply(rule, edge.rest);
  }
}

void Saturation::read(int letter) {
  const auto before = std::move(edges_);
  edges_.clear();
  known_.clear();
  closed_ = 0;
  node_of_.clear();
  known_below_.clear();
  pops_.clear();
  for (const int node : visited_) nodes_[static_cast<std::size_t>(node)].popped_to.clear();
  visited_.clear();
  for (const auto& edge : before)
    for (const auto& rule : system_.rules(edge.control, edge.symbol, letter)) apply(rule, edge.rest);
}

void Saturation::apply(const PushdownRule& rule, int rest) {
  if (++applied_ > most_applied) return;
  const auto& word = rule.word;
  if (word.empty()) return pop(rule.control, rest);
  std::vector<int> key{rule.control};
  int from = -1;
  for (std::size_t i = 0; i < word.size(); ++i) {
    key.push_back(word[i]);
    const int to = i + 1 == word.size() ? rest : node(key);
    if (i == 0)
      add({rule.control, word[i], to});
    else
      add_below(from, word[i], to);
    from = to;
  }
}

void Saturation::add(Edge edge) {
  ++applied_;
  if (known_.insert(edge).second) edges_.push_back(edge);
}

// Adds an edge below a node. Controls that popped down to the node also reach the new edge.
void Saturation::add_below(int node, int symbol, int rest) {
  if (!known_below_.insert({node, symbol, rest}).second) return;
  nodes_[static_cast<std::size_t>(node)].edges.emplace_back(symbol, rest);
  for (const int control : nodes_[static_cast<std::size_t>(node)].popped_to) add({control, symbol, rest});
}

void Saturation::pop(int control, int rest) {
  if (!pops_.insert({control, 0, rest}).second) return;
  auto& node = nodes_[static_cast<std::size_t>(rest)];
  node.popped_to.push_back(control);
  visited_.push_back(rest);
  for (const auto& [symbol, below] : node.edges) add({control, symbol, below});
}

int Saturation::node(std::vector<int> key) {
  const auto [known, fresh] = node_of_.emplace(std::move(key), static_cast<int>(nodes_.size()));
  if (fresh) nodes_.emplace_back();
  return known->second;
}

}  // namespace continua
