#include "continua/analysis/head_analysis.h"

#include <algorithm>
#include <deque>
#include <functional>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/analysis/saturation.h"
#include "continua/automaton/stack_operation.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

constexpr std::size_t most_searched = 5000;

// A symbol for each way in which input sets of the machine can overlap: all named symbols, and one for each prefix.
std::vector<std::string> letters_of(const Machine& machine) {
  std::set<std::string> letters;
  for (const auto& transition : machine.transitions) {
    if (!transition.on) continue;
    letters.insert(transition.on->names.begin(), transition.on->names.end());
    for (const auto& prefix : transition.on->prefixes) letters.insert(prefix + "…");
  }
  return {letters.begin(), letters.end()};
}

std::string values_of(const Machine& machine, const Configuration& head) {
  std::vector<std::string> values;
  const auto& top = head.stack.top();
  for (std::size_t i = 0; i < top.size(); ++i)
    if (!(top[i].value == empty_value(machine.slots[i].type)))
      values.push_back(fmt::format("{} = {}", machine.slots[i].name, print(top[i].value)));
  if (values.empty() && same_values(top, bottom_symbol(machine)) && !top.empty()) values.push_back("the bottom symbol");
  for (std::size_t i = 0; i < head.memory->size(); ++i)
    values.push_back(fmt::format("{} = {}", machine.memory[i].name, print((*head.memory)[i].value)));
  return fmt::format("{}", fmt::join(values, ", "));
}

// State, topmost symbol and registers as text.
std::string head_key(const Configuration& head) {
  auto key = std::to_string(head.state);
  for (const auto& cell : head.stack.top()) key += '\n' + print(cell.value);
  for (const auto& cell : *head.memory) key += '\n' + print(cell.value);
  return key;
}

// Analyses a machine with finitely many heads: examines each reachable head.
class Decided {
 public:
  Decided(const std::shared_ptr<const Machine>& machine, MachineAnalysis& analysis)
      : machine_(machine), analysis_(analysis), system_(machine), letters_(letters_of(*machine)) {
    for (const auto& letter : letters_) letter_ids_.push_back(system_.letter(letter));
  }

  // Returns whether the machine could be decided.
  bool run() {
    Saturation reached(system_);
    reached.close(letter_ids_);
    if (system_.overflowed() || reached.exhausted()) return false;
    std::set<StateIndex> states;
    std::set<std::pair<int, int>> heads;
    for (const auto& edge : reached.edges())
      if (heads.insert({edge.control, edge.symbol}).second) look_at(edge.control, edge.symbol);
    for (const auto& [control, symbol] : heads)
      if (system_.ready(control)) states.insert(system_.state(control));
    for (StateIndex state = 0; state < machine_->states.size(); ++state)
      if (!states.contains(state)) analysis_.unreachable.push_back(state);
    for (std::size_t i = 0; i < machine_->transitions.size(); ++i)
      if (!fires_.contains(i)) analysis_.never_fires.push_back(i);
    find_words();
    find_epsilon_cycles(heads);
    return true;
  }

 private:
  struct Taker {
    std::size_t transition;
    std::optional<std::string> input;
  };

  void look_at(int control, int symbol) {
    std::vector<Taker> silent;
    for (const auto& rule : system_.rules(control, symbol, PushdownSystem::epsilon))
      if (rule.transition) silent.push_back({*rule.transition, std::nullopt});
    note(silent, control, symbol);
    for (std::size_t i = 0; i < letters_.size(); ++i) {
      auto takers = machine_->epsilon_always ? silent : std::vector<Taker>();
      for (const auto& rule : system_.rules(control, symbol, letter_ids_[i]))
        if (rule.transition) takers.push_back({*rule.transition, letters_[i]});
      note(takers, control, symbol);
    }
  }

  void note(const std::vector<Taker>& takers, int control, int symbol) {
    for (std::size_t a = 0; a < takers.size(); ++a) {
      fires_.insert(takers[a].transition);
      for (std::size_t b = 0; b < a; ++b) {
        const auto [first, second] = std::minmax(takers[a].transition, takers[b].transition);
        const auto head = system_.head(control, symbol);
        if (!pairs_.insert({head.state, first, second}).second) continue;
        const auto& input = takers[a].input ? takers[a].input : takers[b].input;
        analysis_.conflicts.push_back({head.state, first, second, input, values_of(*machine_, head), std::nullopt});
        conflict_heads_.push_back(head_key(head));
      }
    }
  }

  // Finds words that lead to conflicts: breadth first over real configurations, shortest words first. A head beyond the
  // bound gets no word.
  void find_words() {
    std::multimap<std::string, std::size_t> wanted;
    for (std::size_t i = 0; i < conflict_heads_.size(); ++i) wanted.emplace(conflict_heads_[i], i);
    const Rules none;
    const Beliefs beliefs(machine_->beliefs);
    const Facts facts{.beliefs = &beliefs};
    const Stepper stepper(machine_, none);
    std::deque<std::pair<Configuration, std::string>> open{{stepper.initial(), ""}};
    std::vector<Configuration> seen;
    const auto reach = [&](Configuration configuration, std::string word) {
      const auto again = [&](const Configuration& other) { return other.same_as(configuration); };
      if (seen.size() == most_searched || std::any_of(seen.begin(), seen.end(), again)) return;
      seen.push_back(configuration);
      open.emplace_back(std::move(configuration), std::move(word));
    };
    while (!open.empty() && !wanted.empty()) {
      const auto [configuration, word] = std::move(open.front());
      open.pop_front();
      const auto [first, last] = wanted.equal_range(head_key(configuration));
      for (auto found = first; found != last; ++found) analysis_.conflicts[found->second].word = word;
      wanted.erase(first, last);
      for (std::size_t i = 0; i <= letters_.size(); ++i) {
        Input input;
        if (i > 0) input.symbol = letters_[i - 1];
        const auto offered = stepper.firing(configuration, i > 0 ? &input : nullptr, facts, nullptr).applicable();
        for (const auto& candidate : offered.candidates) {
          auto firing = stepper.firing(configuration, i > 0 ? &input : nullptr, facts, nullptr);
          if (!firing.fire({candidate.transition, 1, {}, false}, {}, 0)) continue;
          const auto longer = i == 0 ? word : word.empty() ? letters_[i - 1] : word + " " + letters_[i - 1];
          reach(std::move(firing).take(), longer);
        }
      }
    }
  }

  // Finds ε-cycles: a circle of rules that replace one symbol by one leads back to the same configuration.
  void find_epsilon_cycles(const std::set<std::pair<int, int>>& heads) {
    std::map<std::pair<int, int>, int> visits;  // 1 under way, 2 done
    std::vector<std::pair<std::pair<int, int>, std::optional<std::size_t>>> path;
    const std::function<void(std::pair<int, int>)> visit = [&](std::pair<int, int> head) {
      if (visits[head] == 2 || path.size() > most_searched) return;
      if (visits[head] == 1) {
        std::vector<std::size_t> cycle;
        for (auto step = path.rbegin(); step != path.rend(); ++step) {
          if (step->second) cycle.insert(cycle.begin(), *step->second);
          if (step->first == head) break;
        }
        analysis_.epsilon_cycles.push_back(std::move(cycle));
        return;
      }
      visits[head] = 1;
      for (const auto& rule : std::vector(system_.rules(head.first, head.second, PushdownSystem::epsilon))) {
        if (rule.word.size() != 1) continue;
        path.emplace_back(head, rule.transition);
        visit({rule.control, rule.word[0]});
        path.pop_back();
      }
      visits[head] = 2;
    };
    for (const auto& head : heads) visit(head);
  }

  std::shared_ptr<const Machine> machine_;
  MachineAnalysis& analysis_;
  PushdownSystem system_;
  std::vector<std::string> letters_;
  std::vector<int> letter_ids_;
  std::set<std::size_t> fires_;
  std::set<std::tuple<StateIndex, std::size_t, std::size_t>> pairs_;
  std::vector<std::string> conflict_heads_;  // head_key() of the head of each conflict in analysis_.conflicts
};

}  // namespace

bool analyse_heads(const std::shared_ptr<const Machine>& machine, MachineAnalysis& analysis) {
  return Decided(machine, analysis).run();
}

}  // namespace continua
