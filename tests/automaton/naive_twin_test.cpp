// The engine against the naive twin: the same machines, every word up to a length, compared after every symbol.
#include <cstdlib>
#include <deque>

#include "machines.h"
#include "reference/naive_automaton.h"
#include "reference/naive_machines.h"

using namespace continua;

namespace {

const std::size_t longest_word = 6;

// How many machines are drawn; CONTINUA_TWIN_MACHINES asks for more than a test run has time for.
std::uint64_t samples() {
  const char* wanted = std::getenv("CONTINUA_TWIN_MACHINES");
  return wanted ? std::strtoull(wanted, nullptr, 10) : 400;
}

// A text with a character for each slot, as the twin has it.
naive::Symbol symbol_text(const Symbol& symbol) {
  naive::Symbol text;
  for (const auto& cell : symbol) text += cell.value.is_null() ? "-" : cell.value.text_value();
  return text;
}

naive::Stack stack_text(Stack stack) {
  naive::Stack symbols;
  for (; !stack.empty(); stack = stack.pop()) symbols.insert(symbols.begin(), symbol_text(stack.top()));
  return symbols;
}

// What can be seen of a machine after a step.
std::string seen(std::size_t state, const naive::Stack& stack, bool accepting, bool refused, bool trouble) {
  return fmt::format("{} [{}]{}{}{}", static_cast<char>('P' + state), fmt::join(stack, " "),
                     accepting ? " accepting" : "", refused ? " refused" : "", trouble ? " trouble" : "");
}

class Engine {
 public:
  explicit Engine(const std::string& json)
      : machine_(machine_of(json)), stepper_(machine_, no_methods), beliefs_(machine_->beliefs) {}

  Step begin() { return stepper_.begin(beliefs_, machine_->choice, random_); }
  Step step(const Configuration& before, char symbol) {
    Input input;
    input.symbol = std::string(1, symbol);
    return stepper_.step(before, input, beliefs_, machine_->choice, random_);
  }

  std::string seen_after(const Step& step) const {
    bool refused = false, trouble = false;
    for (const auto& event : step.events) {
      refused = refused || std::holds_alternative<RefusedInput>(event);
      trouble = trouble || std::holds_alternative<Trouble>(event);
    }
    const auto& state = machine_->states[step.after.state];
    return seen(state.name[0] - 'P', stack_text(step.after.stack), state.accepting, refused, trouble);
  }

 private:
  std::shared_ptr<const Machine> machine_;
  Stepper stepper_;
  Beliefs beliefs_;
  Random random_{1};
};

std::string seen_after(const naive::Machine& machine, const naive::Step& step) {
  return seen(step.after.state, step.after.stack, machine.states[step.after.state].accepting, step.refused,
              step.trouble != naive::Trouble::none);
}

struct Agreement {
  std::size_t machines = 0, words = 0;
};

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

}  // namespace

TEST_CASE("the engine does what its naive twin does, with every two operations") {
  Agreement agreed;
  for (const auto& machine : naive::machines_of_two_operations()) compare_words(machine, agreed);
  CHECK(agreed.words == agreed.machines * 127);
}

TEST_CASE("the engine does what its naive twin does, on sampled machines and all short words") {
  Agreement agreed;
  for (std::uint64_t number = 0; number < samples(); ++number) {
    CAPTURE(number);
    compare_words(naive::sampled_machine(number), agreed);
  }
  WARN(agreed.machines << " machines and " << agreed.words << " words agree");
}
