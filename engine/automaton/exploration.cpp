#include "continua/automaton/exploration.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

namespace continua {

// The work of one step: configurations in the order in which they are reached.
class Explorer::Work {
 public:
  Work(const Stepper& stepper, std::size_t limit, const Facts& facts, const Exploration& before)
      : stepper_(stepper), limit_(std::max<std::size_t>(limit, 1)), facts_(facts) {
    result_.after = before;
    result_.after.branches.clear();
  }

  void begin() {
    auto configuration = stepper_.initial();
    result_.after.next = configuration.next;
    Node node;
    node.events.push_back(MadeSymbol{configuration.stack.id(), std::nullopt, configuration.stack.top()});
    node.branch.configuration = std::move(configuration);
    node.settles = stepper_.machine().epsilon_always;
    reach(std::move(node));
    result_.after.next_branch = 1;
  }

  void offer(const Branch& branch, std::span<const Input> inputs) {
    Node from;
    from.branch = branch;
    from.branch.by.clear();
    from.branch.parent = branch.id;
    if (!fire_all(from, inputs)) result_.dropped.push_back(branch.id);
  }

  // Follows ε-transitions, also from the configurations reached by them, up to a bound.
  void close() {
    const auto last = result_.after.steps + most_epsilon_steps + static_cast<int>(limit_);
    for (std::size_t next = 0; next < open_.size(); ++next) {
      const auto i = open_[next];
      if (nodes_[i].pruned) continue;
      if (result_.after.steps > last) {
        nodes_[i].branch.settled = false;
        nodes_[i].events.push_back(Trouble{"ε-transitions go on and on; those from here on have not been tried"});
        continue;
      }
      const Node from = nodes_[i];
      nodes_[i].branch.settled = !fire_all(from, {});
    }
  }

  bool nothing() const { return nodes_.empty(); }

  ExplorationStep result() && {
    std::erase_if(nodes_, [](const Node& node) { return node.pruned; });
    std::stable_sort(nodes_.begin(), nodes_.end(), [](const Node& a, const Node& b) {
      return std::pair(!a.branch.settled, -a.branch.weight) < std::pair(!b.branch.settled, -b.branch.weight);
    });
    double total = 0;
    for (const auto& node : nodes_) total += node.branch.weight;
    std::set<int> taken, told;
    for (auto& node : nodes_) {
      node.branch.id = taken.insert(node.branch.parent).second ? node.branch.parent : result_.after.next_branch++;
      node.branch.weight /= total;
      for (const auto& event : node.events)  // branches of one step may share the symbols of its beginning
        if (const auto* made = std::get_if<MadeSymbol>(&event); made && told.insert(made->id).second)
          if (!result_.after.branches.empty()) result_.made.push_back(event);
      if (result_.after.branches.empty()) {
        result_.events = std::move(node.events);
      } else {
        std::erase_if(node.events, [](const StepEvent& event) { return std::holds_alternative<MadeSymbol>(event); });
        if (!node.events.empty())
          result_.others.push_back({node.branch.id, node.branch.parent, std::move(node.events)});
      }
      result_.after.branches.push_back(std::move(node.branch));
    }
    return std::move(result_);
  }

 private:
  struct Node {
    Branch branch;
    std::vector<StepEvent> events;  // since the step began
    const Input* input = nullptr;   // that the step takes; what follows from it by ε draws on it too
    bool settles = true;            // ε-transitions are to be tried
    bool pruned = false;
  };

  // A firing with these inputs. Without any it is ε, after the input that the step took.
  Firing firing_of(const Node& from, Configuration configuration, std::span<const Input> inputs,
                   std::vector<StepEvent>* account) const {
    if (!inputs.empty() || !from.input) return stepper_.firing(std::move(configuration), inputs, facts_, account);
    auto firing = stepper_.firing(std::move(configuration), from.input, facts_, account);
    firing.forget_input();
    return firing;
  }

  // Fires every applicable transition of `from`, each on a copy. Returns whether any fired.
  bool fire_all(const Node& from, std::span<const Input> inputs) {
    const auto& configuration = from.branch.configuration;
    std::vector<StepEvent> unused;
    const auto found = firing_of(from, configuration, inputs, &unused).applicable();
    double total = 0;
    for (const auto& candidate : found.candidates) total += candidate.weight;
    bool any = false;
    for (const auto& candidate : found.candidates) {
      Node node = from;
      node.branch.configuration.next = result_.after.next;
      auto firing = firing_of(from, std::move(node.branch.configuration), inputs, &node.events);
      if (!inputs.empty()) node.input = &inputs[candidate.alternative];
      const Chosen chosen{candidate.transition, candidate.weight / total, std::nullopt, false, candidate.alternative};
      const auto settles = firing.fire(chosen, found, ++result_.after.steps);
      if (!settles) continue;
      any = true;
      node.branch.configuration = std::move(firing).take();
      result_.after.next = node.branch.configuration.next;
      node.branch.by.push_back(candidate.transition);
      node.branch.weight = from.branch.weight * candidate.weight;
      node.settles = *settles;
      reach(std::move(node));
    }
    return any;
  }

  // Adds a configuration to the set. An equal one that is known gets the larger weight; a full set drops the lightest.
  void reach(Node node) {
    auto& alike = alike_[{node.branch.configuration.state, node.branch.configuration.stack.depth()}];
    for (const auto index : alike) {
      auto& known = nodes_[index];
      if (known.pruned || !known.branch.configuration.same_as(node.branch.configuration)) continue;
      ++result_.merged;
      if (node.settles && !known.settles) open_.push_back(index);
      known.settles = known.settles || node.settles;
      if (known.branch.weight < node.branch.weight) {
        known.branch.weight = node.branch.weight;
        known.branch.by = std::move(node.branch.by);
        known.branch.parent = node.branch.parent;
        known.branch.configuration = std::move(node.branch.configuration);
        known.events = std::move(node.events);
        known.input = node.input;
      }
      return;
    }
    if (kept_ == limit_) {
      ++result_.pruned;
      auto lightest = nodes_.end();
      for (auto one = nodes_.begin(); one != nodes_.end(); ++one)
        if (!one->pruned && (lightest == nodes_.end() || one->branch.weight <= lightest->branch.weight)) lightest = one;
      if (lightest->branch.weight >= node.branch.weight) return;
      *lightest = Node();
      lightest->pruned = true;
      --kept_;
    }
    ++kept_;
    alike.push_back(nodes_.size());
    if (node.settles) open_.push_back(nodes_.size());
    nodes_.push_back(std::move(node));
  }

  const Stepper& stepper_;
  std::size_t limit_;
  const Facts& facts_;
  std::vector<Node> nodes_;
  std::map<std::pair<StateIndex, std::size_t>, std::vector<std::size_t>> alike_;  // by state and depth
  std::vector<std::size_t> open_;  // nodes with ε-transitions still to be tried, in order
  std::size_t kept_ = 0;
  ExplorationStep result_;
};

ExplorationStep Explorer::begin(const Facts& facts) const {
  Work work(stepper_, limit_, facts, {});
  work.begin();
  work.close();
  return std::move(work).result();
}

ExplorationStep Explorer::step(const Exploration& before, std::span<const Input> inputs, const Facts& facts) const {
  require(!inputs.empty(), "an input is offered");
  Work work(stepper_, limit_, facts, before);
  for (const auto& branch : before.branches) work.offer(branch, inputs);
  if (!work.nothing()) {
    work.close();
    return std::move(work).result();
  }
  ExplorationStep refused;
  refused.after = before;
  const auto& leading = before.branches.front().configuration;
  auto found = stepper_.firing(leading, inputs, facts, &refused.events).applicable();
  refused.events.push_back(refusal(stepper_.machine(), leading.state, std::move(found), inputs));
  return refused;
}

}  // namespace continua
