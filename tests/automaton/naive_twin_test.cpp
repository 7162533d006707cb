// The engine against the naive twin: the same machines, every word up to a length, compared after every symbol.
#include <deque>
#include <set>

#include "reference/naive_exploration.h"
#include "reference/naive_machines.h"
#include "support/small_engine.h"
#include "support/twin_samples.h"

using namespace continua;

namespace {

std::string marked(const std::string& configuration, bool accepting, bool refused, bool trouble) {
  return configuration + (accepting ? " accepting" : "") + (refused ? " refused" : "") + (trouble ? " trouble" : "");
}

std::string seen_after(const Machine& machine, const Step& step) {
  return marked(text_of(step.after), machine.states[step.after.state].accepting, has<RefusedInput>(step.events),
                has<Trouble>(step.events));
}

std::string seen_after(const naive::Machine& machine, const naive::Step& step) {
  return marked(state_and_stack(step.after.state, step.after.stack), machine.states[step.after.state].accepting,
                step.refused, step.trouble != naive::Trouble::none);
}

std::set<std::string> seen_after(const ExplorationStep& step) {
  std::set<std::string> all;
  for (const auto& branch : step.after.branches) all.insert(text_of(branch.configuration));
  return all;
}

std::set<std::string> seen_after(const naive::Configurations& configurations) {
  std::set<std::string> all;
  for (const auto& one : configurations) all.insert(state_and_stack(one.state, one.stack));
  return all;
}

// Every word in order of length. A machine whose ε-transitions grow its stack without end is slow to copy, and left
// there.
void compare_words(const naive::Machine& machine, Agreement& agreed) {
  const std::string text = naive::json(machine);
  CAPTURE(text);
  SmallEngine engine(text);
  struct Run {
    std::string word;
    naive::Step twin;
    Step step;
  };
  std::deque<Run> runs = {{"", naive::begin(machine), engine.begin()}};
  for (bool endless = false; !runs.empty() && !endless; runs.pop_front()) {
    const auto& [word, twin, step] = runs.front();
    CAPTURE(word);
    REQUIRE(seen_after(engine.machine(), step) == seen_after(machine, twin));
    ++agreed.words;
    endless = twin.trouble == naive::Trouble::endless;
    if (word.size() == longest_word) continue;
    for (const char input : {'a', 'b'})
      runs.push_back({word + input, naive::step(machine, twin.after, input), engine.step(step.after, input)});
  }
  ++agreed.machines;
}

// Sequences of inputs of which one is to be taken, each told from all others by its outcome.
const std::vector<std::vector<naive::Offer>> offers = {
    {{'a', 1}, {'b', 0.5}}, {{'a', 0.25}, {'b', 1}},  {{'b', 0.5}, {'a', 0.5}},
    {{'a', 0}, {'b', 1}},   {{'a', 0.5}, {'a', 0.5}}, {{'b', 0}, {'c', 1}, {'a', 0.125}, {'b', 0.125}}};
const std::size_t longest_offered = 3;

std::string taken_after(const Step& step) {
  for (const auto& event : step.events)
    if (const auto* fired = std::get_if<Fired>(&event)) return " " + std::to_string(fired->alternative);
  return "";
}

void compare_offers(const naive::Machine& machine, Agreement& agreed) {
  const std::string text = naive::json(machine);
  CAPTURE(text);
  SmallEngine engine(text);
  struct Run {
    std::size_t length;
    naive::Step twin;
    Step step;
  };
  std::deque<Run> runs = {{0, naive::begin(machine), engine.begin()}};
  for (; !runs.empty() && runs.front().twin.trouble != naive::Trouble::endless; runs.pop_front()) {
    const auto& [length, twin, step] = runs.front();
    if (length == longest_offered) break;
    for (std::size_t i = 0; i < offers.size(); ++i) {
      const Run next{length + 1, naive::step(machine, twin.after, offers[i]), engine.step(step.after, offers[i])};
      CAPTURE(length, i, text_of(step.after));
      REQUIRE(seen_after(engine.machine(), next.step) + taken_after(next.step) ==
              seen_after(machine, next.twin) + (next.twin.refused ? "" : " " + std::to_string(next.twin.taken)));
      ++agreed.words;
      runs.push_back(next);
    }
  }
  ++agreed.machines;
}

void compare_offered_sets(const naive::Machine& machine, Agreement& agreed) {
  const std::string text = naive::json(machine);
  CAPTURE(text);
  SmallEngine engine(text, 10 * most_compared);
  auto twin = naive::explored(machine, most_compared);
  if (!twin) return;
  auto step = engine.explore();
  for (const auto& offered : offers) {
    const auto next = naive::explored(machine, *twin, offered, most_compared);
    if (!next) return;
    step = engine.explore(step.after, offered);
    REQUIRE(has<RefusedInput>(step.events) == next->empty());
    if (!next->empty()) twin = next;
    REQUIRE(seen_after(step) == seen_after(*twin));
    ++agreed.words;
  }
  ++agreed.machines;
}

// The same of all runs at once, as long as there are not too many for the twin to compare one by one.
void compare_sets(const naive::Machine& machine, Agreement& agreed) {
  const std::string text = naive::json(machine);
  CAPTURE(text);
  SmallEngine engine(text, 10 * most_compared);
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
    REQUIRE(seen_after(step) == seen_after(twin));
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
  for (const auto& machine : naive::machines_of_two_operations()) {
    compare_words(machine, agreed);
    compare_sets(machine, agreed);
  }
}

TEST_CASE("a configuration that a rewrite leads to has ε-transitions, whatever else led to it before") {
  using Kind = naive::Operation::Kind;
  naive::Machine machine;
  machine.epsilon_always = false;
  machine.states.resize(3);
  machine.transitions = {
      {{0}, "a", "..", 1, 1, {}}, {{0}, "a", "..", 1, 1, {Kind::rewrite, {".."}}}, {{1}, "", "..", 2, 1, {}}};
  Agreement agreed;
  compare_sets(machine, agreed);
}

TEST_CASE("the engine does what its naive twin does, on sampled machines and all short words") {
  Agreement agreed;
  for (std::uint64_t number = 0; number < samples(100); ++number) {
    CAPTURE(number);
    compare_words(naive::sampled_machine(number), agreed);
  }
  agreed.tell();
}

TEST_CASE("the engine explores what its naive twin explores, on sampled machines and all short words") {
  Agreement agreed;
  for (std::uint64_t number = 0; number < samples(150); ++number) {
    CAPTURE(number);
    compare_sets(naive::sampled_machine(number), agreed);
  }
  agreed.tell();
}

TEST_CASE("offered several inputs at once, the engine takes what its naive twin takes") {
  Agreement agreed;
  for (std::uint64_t number = 0; number < samples(100); ++number) {
    CAPTURE(number);
    compare_offers(naive::sampled_machine(number), agreed);
    compare_offered_sets(naive::sampled_machine(number), agreed);
  }
  agreed.tell();
}
