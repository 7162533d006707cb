// The engine against the naive twin: the same machines, every word up to a length, compared after every symbol.
#include <algorithm>
#include <deque>
#include <set>

#include "automaton/exploration.h"
#include "machines.h"
#include "reference/naive_automaton.h"
#include "reference/naive_exploration.h"
#include "reference/naive_machines.h"
#include "twin_samples.h"

using namespace continua;

namespace {

const std::size_t most_configurations = 10 * most_compared;

// As the twin has it.
naive::Stack stack_of(Stack stack) {
  naive::Stack symbols;
  for (; !stack.empty(); stack = stack.pop()) {
    naive::Symbol symbol = naive::bottom;
    for (std::size_t slot = 0; slot < stack.top().size(); ++slot)
      if (const Term& value = stack.top()[slot].value; !value.is_null()) symbol[slot] = value.text_value().at(0);
    symbols.insert(symbols.begin(), symbol);
  }
  return symbols;
}

Input input_of(char symbol) {
  Input input;
  input.symbol = std::string(1, symbol);
  return input;
}

std::string state_and_stack(std::size_t state, const naive::Stack& stack) {
  std::string text(1, static_cast<char>('P' + state));
  for (const auto& [symbol, held] : stack) text += {' ', symbol, held};
  return text;
}

// What can be seen of a machine after a step.
std::string seen(std::size_t state, const naive::Stack& stack, bool accepting, bool refused, bool trouble) {
  return fmt::format("{}{}{}{}", state_and_stack(state, stack), accepting ? " accepting" : "",
                     refused ? " refused" : "", trouble ? " trouble" : "");
}

template <class Event>
bool has(const std::vector<StepEvent>& events) {
  return std::any_of(events.begin(), events.end(), [](const auto& one) { return std::holds_alternative<Event>(one); });
}

class Engine {
 public:
  explicit Engine(const std::string& json)
      : machine_(machine_of(json)),
        stepper_(machine_, no_methods),
        beliefs_(machine_->beliefs),
        chooser_{machine_->choice, Random(0), {}, 0} {}

  Step begin() { return stepper_.begin(beliefs_, chooser_); }
  Step step(const Configuration& before, char symbol) {
    return stepper_.step(before, input_of(symbol), beliefs_, chooser_);
  }
  ExplorationStep explore() { return Explorer(stepper_, most_configurations).begin(beliefs_); }
  ExplorationStep explore(const Exploration& before, char symbol) {
    return Explorer(stepper_, most_configurations).step(before, input_of(symbol), beliefs_);
  }

  std::string seen_after(const ExplorationStep& step) const {
    std::set<std::string> all;
    for (const auto& branch : step.after.branches)
      all.insert(state_and_stack(branch.configuration.state, stack_of(branch.configuration.stack)));
    return fmt::format("{}", fmt::join(all, ", "));
  }

  std::string seen_after(const Step& step) const {
    const auto& state = machine_->states[step.after.state];
    return seen(state.name[0] - 'P', stack_of(step.after.stack), state.accepting, has<RefusedInput>(step.events),
                has<Trouble>(step.events));
  }

 private:
  std::shared_ptr<const Machine> machine_;
  Stepper stepper_;
  Beliefs beliefs_;
  Chooser chooser_;
};

std::string seen_after(const naive::Machine& machine, const naive::Step& step) {
  return seen(step.after.state, step.after.stack, machine.states[step.after.state].accepting, step.refused,
              step.trouble != naive::Trouble::none);
}

std::string seen_after(const naive::Configurations& configurations) {
  std::set<std::string> all;
  for (const auto& one : configurations) all.insert(state_and_stack(one.state, one.stack));
  return fmt::format("{}", fmt::join(all, ", "));
}

// Every word in order of length. What ε-transitions blow up without end is slow to copy: such a machine is left there.
void compare_words(const naive::Machine& machine, Agreement& agreed) {
  const std::string text = naive::json(machine);
  CAPTURE(text);
  Engine engine(text);
  struct Run {
    std::string word;
    naive::Step twin;
    Step step;
  };
  std::deque<Run> runs = {{"", naive::begin(machine), engine.begin()}};
  for (bool endless = false; !runs.empty() && !endless; runs.pop_front()) {
    const auto& [word, twin, step] = runs.front();
    CAPTURE(word);
    REQUIRE(engine.seen_after(step) == seen_after(machine, twin));
    ++agreed.words;
    endless = twin.trouble == naive::Trouble::endless;
    if (word.size() == longest_word) continue;
    for (const char input : {'a', 'b'})
      runs.push_back({word + input, naive::step(machine, twin.after, input), engine.step(step.after, input)});
  }
  ++agreed.machines;
}

// The same of all runs at once, as long as there are not too many for the twin to compare one by one.
void compare_sets(const naive::Machine& machine, Agreement& agreed) {
  const std::string text = naive::json(machine);
  CAPTURE(text);
  Engine engine(text);
  struct Run {
    std::string word;
    naive::Configurations twin;
    ExplorationStep step;
  };
  std::deque<Run> runs;
  if (const auto twin = naive::explored(machine, most_compared)) runs.push_back({"", *twin, engine.explore()});
  for (; !runs.empty(); runs.pop_front()) {
    const auto& [word, twin, step] = runs.front();
    CAPTURE(word);
    REQUIRE(engine.seen_after(step) == seen_after(twin));
    ++agreed.words;
    if (word.size() == longest_word) continue;
    for (const char input : {'a', 'b'}) {
      const auto next = naive::explored(machine, twin, input, most_compared);
      if (!next) continue;
      const auto explored = engine.explore(step.after, input);
      CAPTURE(input);
      REQUIRE(has<RefusedInput>(explored.events) == next->empty());
      runs.push_back({word + input, next->empty() ? twin : *next, explored});
    }
  }
  ++agreed.machines;
}

}  // namespace

TEST_CASE("the engine does what its naive twin does, with every two operations") {
  Agreement agreed;
  for (const auto& machine : naive::machines_of_two_operations()) compare_words(machine, agreed);
  CHECK(agreed.words == agreed.machines * 127);
}

TEST_CASE("the engine does what its naive twin does, on sampled machines and all short words") {
  Agreement agreed;
  for (std::uint64_t number = 0; number < samples(400); ++number) {
    CAPTURE(number);
    compare_words(naive::sampled_machine(number), agreed);
  }
  agreed.tell();
}

TEST_CASE("the engine explores what its naive twin explores, on sampled machines and all short words") {
  Agreement agreed;
  for (std::uint64_t number = 0; number < samples(400); ++number) {
    CAPTURE(number);
    compare_sets(naive::sampled_machine(number), agreed);
  }
  agreed.tell();
}
