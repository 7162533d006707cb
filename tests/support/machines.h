// A small vocabulary for tests of the automaton: machines as text, inputs as words, and events as text.
#pragma once

#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "continua/automaton/stepper.h"
#include "continua/machine_file/machine_loader.h"
#include "continua/term/term_text.h"
#include "support/catch.h"

namespace continua {

inline const Rules no_facts;

inline std::shared_ptr<const Machine> machine_of(const std::string& text, const RaisingRules& raising = {}) {
  auto machine = parse_machine(text, "m.json", {}, "", "", raising);
  if (!machine) FAIL(machine.error().text());
  return std::make_shared<const Machine>(std::move(*machine));
}

/// A machine that takes one symbol after another and reports its state.
class Player {
 public:
  explicit Player(const std::string& text, std::optional<Choice> choice = std::nullopt, std::uint64_t seed = 1)
      : Player(machine_of(text), choice, seed) {}
  Player(const std::string& text, const RaisingRules& raising)
      : Player(machine_of(text, raising), std::nullopt, 1, &raising) {}
  explicit Player(std::shared_ptr<const Machine> machine, std::optional<Choice> choice = std::nullopt,
                  std::uint64_t seed = 1, const RaisingRules* raising = nullptr)
      : machine_(std::move(machine)),
        stepper_(machine_, no_facts, raising),
        beliefs_(machine_->beliefs),
        chooser_{choice.value_or(machine_->choice), Random(seed), {}, 0} {
    take(stepper_.begin(facts(), chooser_));
  }

  /// Offers symbols, separated by ", ".
  Player& feed(const std::string& symbols, double confidence = 1) {
    for (std::size_t at = 0; at <= symbols.size();) {
      const auto comma = std::min(symbols.find(", ", at), symbols.size());
      Input input;
      input.serial = ++serial_;
      input.symbol = symbols.substr(at, comma - at);
      input.target = Term::point(serial_, 0, 0);
      input.confidence = confidence;
      take(stepper_.step(configuration_, input, facts(), chooser_));
      at = comma + 2;
    }
    return *this;
  }

  /// Offers several symbols at once, of which one is to be taken: "yes 0.7, no 0.3".
  Player& offer(const std::string& alternatives) {
    std::vector<Input> inputs;
    std::istringstream words(alternatives);
    for (std::string symbol, confidence; words >> symbol >> confidence;) {
      inputs.emplace_back();
      inputs.back().serial = serial_ + static_cast<int>(inputs.size());
      inputs.back().symbol = symbol;
      inputs.back().target = Term::point(inputs.back().serial, 0, 0);
      inputs.back().confidence = std::stod(confidence);
    }
    serial_ += static_cast<int>(inputs.size());
    take(stepper_.step(configuration_, inputs, facts(), chooser_));
    return *this;
  }

  std::string state() const { return machine_->states[configuration_.state].name; }
  /// The value of a slot of the topmost symbol, printed.
  std::string slot(const std::string& name) const {
    return print(configuration_.stack.top()[machine_->slot_index.at(name)].value);
  }
  std::size_t depth() const { return configuration_.stack.depth(); }
  const Configuration& configuration() const { return configuration_; }
  Beliefs& beliefs() { return beliefs_; }
  /// The events of the latest step.
  const std::vector<StepEvent>& events() const { return events_; }

  template <class Event>
  std::vector<Event> all() const {
    std::vector<Event> found;
    for (const auto& event : events_)
      if (const auto* one = std::get_if<Event>(&event)) found.push_back(*one);
    return found;
  }
  /// The ids of the transitions that the latest step fired.
  std::string fired() const {
    std::string ids;
    for (const auto& one : all<Fired>()) ids += (ids.empty() ? "" : " ") + machine_->transitions[one.transition].id;
    return ids;
  }
  /// The number of the input that the latest step took; of several transitions, the first one's.
  std::size_t taken() const { return all<Fired>().at(0).alternative; }

 private:
  Facts facts() const { return {.beliefs = &beliefs_}; }
  void take(Step step) {
    configuration_ = std::move(step.after);
    events_ = std::move(step.events);
  }

  std::shared_ptr<const Machine> machine_;
  Stepper stepper_;
  Beliefs beliefs_;
  Chooser chooser_;
  Configuration configuration_;
  std::vector<StepEvent> events_;
  int serial_ = 0;
};

}  // namespace continua
