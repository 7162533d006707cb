#include "continua/automaton/carry_over.h"

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "continua/core/located_json.h"

namespace continua {
namespace {

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& all) {
  std::vector<std::string> names;
  for (const auto& one : all) names.push_back(one.name);
  return names;
}

template <class Named>
std::optional<std::size_t> find(const std::vector<Named>& all, const std::string& name) {
  const auto found = std::find_if(all.begin(), all.end(), [&](const Named& one) { return one.name == name; });
  if (found == all.end()) return std::nullopt;
  return static_cast<std::size_t>(found - all.begin());
}

// The work for one pair of machines. The id of a symbol identifies the whole stack below it.
class CarryOver {
 public:
  CarryOver(const Machine& was, const Machine& now) : was_(was), now_(now) {}

  Configuration configuration(const Configuration& before) {
    Configuration after;
    after.next = before.next;
    after.state = state(before.state);
    after.stack = stack(before.stack);
    after.history = history(before.history, before.state, after);
    after.memory = memory(*before.memory);
    return after;
  }

  const std::optional<Error>& problem() const { return problem_; }

 private:
  void refuse(std::string sentence) {
    if (!problem_) problem_ = Error{now_.name, std::move(sentence)};
  }

  StateIndex state(StateIndex index) {
    const auto& name = was_.states[index].name;
    if (const auto found = find(now_.states, name)) return *found;
    refuse(fmt::format("the run is in the state {}, which this machine lacks{}", in_quotes(name),
                       did_you_mean(name, names_of(now_.states))));
    return now_.start;
  }

  // The slot or register of `now` that takes the value. Refuses if there is none, or it has another type.
  template <class Named>
  std::optional<std::size_t> place(const char* what, const Named& from, const std::vector<Named>& all,
                                   const Term& value) {
    const auto found = find(all, from.name);
    if (!found)
      refuse(fmt::format("{} {} holds {}, and this machine lacks it{}", what, in_quotes(from.name), print(value),
                         did_you_mean(from.name, names_of(all))));
    else if (!consistent(from.type, all[*found].type))
      refuse(fmt::format("{} {} holds {}, of type {}; this machine has it for values of type {}", what,
                         in_quotes(from.name), print(value), from.type.text(), all[*found].type.text()));
    return found;
  }

  Symbol symbol(const Symbol& before) {
    Symbol after;
    for (const auto& slot : now_.slots) after.push_back({empty_value(slot.type), {}});
    for (std::size_t i = 0; i < before.size(); ++i) {
      const auto& slot = was_.slots[i];
      if (before[i].value.is_null() || before[i].value == empty_value(slot.type)) {
        // An emptied slot came of something, too.
        if (const auto same = find(now_.slots, slot.name))
          after[*same] = {after[*same].value, before[i].because, before[i].source};
        continue;
      }
      if (const auto to = place("the stack's slot", slot, now_.slots, before[i].value)) after[*to] = before[i];
    }
    return after;
  }

  Stack stack(const Stack& before) {
    std::vector<Stack> above;  // stacks not translated yet, the topmost first
    Stack rest = before, after;
    for (; !rest.empty(); rest = rest.pop()) {
      if (const auto known = stacks_.find(rest.id()); known != stacks_.end()) {
        after = known->second;
        break;
      }
      above.push_back(rest);
    }
    for (auto one = above.rbegin(); one != above.rend(); ++one) {
      after = after.push(symbol(one->top()), one->id());
      stacks_.emplace(one->id(), after);
    }
    return after;
  }

  // Rebuilds the history by entering the landmarks again, the present state last.
  History history(const History& before, StateIndex present, const Configuration& after) {
    History carried;
    if (now_.landmarks == 0) return carried;
    const auto enter = [&](StateIndex state, const Stack* entry) {
      if (entry) carried = carried.entered(now_.landmark[state], now_.landmarks, stack(*entry));
    };
    const auto entry = [&](StateIndex state, bool now) {
      return was_.landmark[state] ? before.entry(*was_.landmark[state], now) : nullptr;
    };
    for (StateIndex state = 0; state < was_.states.size(); ++state)
      if (const auto to = find(now_.states, was_.states[state].name); to && now_.landmark[*to] && state != present)
        enter(*to, entry(state, false));
    if (now_.landmark[after.state]) {
      enter(after.state, entry(present, true));
      enter(after.state, entry(present, false));
      return carried;
    }
    return carried.entered(std::nullopt, now_.landmarks, after.stack);
  }

  std::shared_ptr<const std::vector<Cell>> memory(const std::vector<Cell>& before) {
    std::vector<Cell> after;
    for (const auto& entry : now_.memory) after.push_back({entry.initial, {}});
    for (std::size_t i = 0; i < before.size(); ++i) {
      if (before[i].value == was_.memory[i].initial && !find(now_.memory, was_.memory[i].name)) continue;
      if (const auto to = place("the register", was_.memory[i], now_.memory, before[i].value)) after[*to] = before[i];
    }
    return std::make_shared<const std::vector<Cell>>(std::move(after));
  }

  const Machine& was_;
  const Machine& now_;
  std::map<int, Stack> stacks_;  // by the id of the topmost symbol
  std::optional<Error> problem_;
};

}  // namespace

Result<Configuration> carried_over(const Configuration& configuration, const Machine& was, const Machine& now) {
  CarryOver work(was, now);
  auto carried = work.configuration(configuration);
  if (work.problem()) return *work.problem();
  return carried;
}

Result<Exploration> carried_over(const Exploration& exploration, const Machine& was, const Machine& now) {
  CarryOver work(was, now);
  auto carried = exploration;
  for (auto& branch : carried.branches) {
    branch.configuration = work.configuration(branch.configuration);
    branch.by.clear();
  }
  if (work.problem()) return *work.problem();
  return carried;
}

void follow_policy(Chooser& chooser, Configuration& configuration, Exploration& exploration) {
  const bool explored = !exploration.branches.empty();
  if (explored == (chooser.policy == Choice::explore)) return;
  if (explored) {
    configuration.next = exploration.next;
    chooser.steps = exploration.steps;
    exploration = {};
    return;
  }
  Branch only;
  only.configuration = configuration;
  exploration = {{std::move(only)}, 1, configuration.next, chooser.steps};
}

}  // namespace continua
