#include "automaton/stepper.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "automaton/condition.h"
#include "automaton/stack_operation.h"
#include "automaton/wording.h"
#include "core/result.h"

namespace continua {
namespace {

constexpr int most_epsilon_steps = 1000;

}  // namespace

Stepper::Stepper(std::shared_ptr<const Machine> machine, const Rules& methods) : machine_(std::move(machine)) {
  own_rules_["is_input"] = {
      1, [this](std::span<const Term> arguments, Evaluation&) {
        return Term::truth(arguments[0].kind() == Term::Kind::text && machine_->knows_input(arguments[0].text_value()));
      }};
  own_rules_["certainty"] = {1, [this](std::span<const Term> arguments, Evaluation&) {
                               return arguments[0].kind() == Term::Kind::text
                                          ? Term::number(beliefs_->certainty(arguments[0].text_value()))
                                          : Term::null();
                             }};
  own_rules_["wording"] = {1, [this](std::span<const Term> arguments, Evaluation& evaluation) {
                             const auto words = wording_of(arguments[0], machine_->wordings, evaluation);
                             return words ? Term::text(*words) : Term::null();
                           }};
  for (const auto& [name, entries] : machine_->tables)
    own_rules_[name] = {1, [&entries = entries](std::span<const Term> arguments, Evaluation& evaluation) {
                          if (arguments[0].kind() != Term::Kind::text) return Term::null();
                          const auto entry = entries.find(arguments[0].text_value());
                          return entry == entries.end() ? Term::null() : evaluation.value(entry->second);
                        }};
  rules_ = {&term_rules(), &methods, &own_rules_};
}

// The work of one step, with all that its parts share.
class Stepper::Run {
 public:
  Run(Stepper& stepper, Configuration configuration, const Input* input, Choice choice, Random& random)
      : stepper_(stepper),
        machine_(*stepper.machine_),
        configuration_(std::move(configuration)),
        serial_(input ? input->serial : 0),
        choice_(choice),
        random_(random) {
    if (input) {
      input_ = Term::text(input->symbol);
      target_ = input->target;
      said_ = input->said;
      confidence_ = Term::number(input->confidence);
      now_ = Term::number(input->now_s);
    }
  }

  void offer(const Input& input) {
    auto found = applicable(&input);
    const auto chosen = choose(found.candidates, choice_, random_);
    if (!chosen) {
      events_.push_back(
          RefusedInput{configuration_.state, input.symbol, refusal_reason(found, input), std::move(found.refused)});
      return;
    }
    const bool settles = fire(*chosen, std::move(found), input.symbol);
    input_ = target_ = said_ = confidence_ = Term::null();
    if (settles) settle();
  }

  // ε-transitions until none applies, or until they go round in a circle.
  void settle() {
    std::vector<Configuration> seen{configuration_};
    std::vector<std::string> path;
    for (int i = 0; i < most_epsilon_steps; ++i) {
      auto found = applicable(nullptr);
      const auto chosen = choose(found.candidates, choice_, random_);
      if (!chosen) return;
      path.push_back(machine_.transitions[chosen->transition].id);
      if (!fire(*chosen, std::move(found), std::nullopt)) return;
      if (std::any_of(seen.begin(), seen.end(), [&](const auto& earlier) { return earlier.same_as(configuration_); })) {
        events_.push_back(Trouble{fmt::format("an ε-cycle that changes nothing: {}", fmt::join(path, ", "))});
        return;
      }
      seen.push_back(configuration_);
    }
    events_.push_back(Trouble{
        fmt::format("more than {} ε-transitions in a row, the last of them {}", most_epsilon_steps, path.back())});
  }

  Term value(const Term& term) {
    auto evaluation = evaluate();
    return evaluation.value(term);
  }

  Step done() && { return {std::move(configuration_), std::move(events_)}; }

 private:
  struct Found {
    std::vector<Candidate> candidates;
    std::vector<Refused> refused;
    double margin = std::numeric_limits<double>::infinity();
  };

  Evaluation evaluate() {
    return Evaluation(stepper_.rules_, [this](const std::string& name) { return look_up(name); });
  }

  // Notes which inputs the value came from: they are what the evaluated content is because of.
  const Term* look_up(const std::string& name) {
    if (const auto slot = machine_.slot_index.find(name); slot != machine_.slot_index.end())
      return read(configuration_.stack.top()[slot->second]);
    if (const auto entry = machine_.register_index.find(name); entry != machine_.register_index.end())
      return read(configuration_.memory[entry->second]);
    if (const auto definition = machine_.definitions.find(name); definition != machine_.definitions.end())
      return &definition->second;
    if (name == "input") return &input_;
    if (name == "target") return &target_;
    if (name == "said") return &said_;
    if (name == "confidence") return &confidence_;
    if (name == "now") return &now_;
    if (name == "in_state") {
      in_state_ = Term::text(machine_.states[configuration_.state].name);
      return &in_state_;
    }
    return nullptr;
  }

  const Term* read(const Cell& cell) {
    because_.insert(cell.because.begin(), cell.because.end());
    return &cell.value;
  }

  Found applicable(const Input* input) {
    Found found;
    for (const auto index : machine_.leaving[configuration_.state]) {
      const auto& transition = machine_.transitions[index];
      if (input ? !transition.on || !transition.on->contains(input->symbol) : transition.on.has_value()) continue;
      auto evaluation = evaluate();
      if (transition.when && !evaluation.value(*transition.when).is_true())
        found.refused.push_back({index, why_not(*transition.when, machine_, evaluation)});
      else
        found.candidates.push_back({index, transition.weight * (input ? input->confidence : 1)});
      found.margin = std::min(found.margin, evaluation.margin);
    }
    return found;
  }

  std::string refusal_reason(const Found& found, const Input& input) const {
    const auto& state = machine_.states[configuration_.state].name;
    if (found.candidates.size() > 1) {
      std::vector<std::string> ids;
      for (const auto& candidate : found.candidates) ids.push_back(machine_.transitions[candidate.transition].id);
      return fmt::format("more than one transition applies: {}", fmt::join(ids, ", "));
    }
    if (!found.refused.empty()) return "no transition's condition holds";
    return fmt::format("no transition from {} takes '{}'", state, input.symbol);
  }

  // Returns whether ε-transitions are to be tried now.
  bool fire(const Chosen& chosen, Found found, const std::optional<std::string>& input) {
    const auto& transition = machine_.transitions[chosen.transition];
    Fired fired{chosen.transition,
                configuration_.state,
                transition.to,
                input,
                &transition.operation,
                std::move(found.candidates),
                std::move(found.refused),
                std::nullopt,
                chosen.probability,
                chosen.draw,
                0,
                0,
                found.margin};
    bool passed = true;
    if (const auto& gate = machine_.states[transition.to].gate) {
      auto evaluation = evaluate();
      passed = evaluation.value(gate->when).is_true();
      fired.gate = GateTest{transition.to, print(gate->when), passed};
      fired.margin = std::min(fired.margin, evaluation.margin);
      if (!passed) {
        fired.to = gate->otherwise;
        fired.operation = &gate->operation;
      }
    }
    operate(*fired.operation);
    const auto to = fired.to;
    const bool rewrote =
        fired.operation->kind == Operation::Kind::rewrite || fired.operation->kind == Operation::Kind::rewrite_each;
    fired.stack = configuration_.stack.id();
    fired.depth = configuration_.stack.depth();
    events_.push_back(std::move(fired));
    bool settles = machine_.epsilon_always || rewrote;
    if (passed && perform(transition.effects)) settles = true;
    configuration_.state = to;
    configuration_.history = configuration_.history.entered(to, configuration_.stack);
    if (perform(machine_.states[to].enter)) settles = true;
    return settles;
  }

  // Carries out an operation on the stack; what it made goes to the events first.
  void operate(const Operation& operation) {
    const auto contents = evaluate_contents(operation);
    auto result = apply_operation(operation, contents, machine_, configuration_);
    for (auto& made : result.made) events_.push_back(MadeSymbol{made.id(), made.id_below(), made.top()});
    if (!result.trouble.empty()) events_.push_back(Trouble{std::move(result.trouble)});
    configuration_.stack = std::move(result.stack);
    configuration_.next_symbol = result.next_symbol;
  }

  std::vector<std::optional<Cell>> evaluate_contents(const Operation& operation) {
    std::vector<std::optional<Cell>> contents;
    for (const auto& content : operation.contents) {
      if (!content.term)
        contents.push_back(std::nullopt);
      else
        contents.push_back(compute(*content.term));
    }
    return contents;
  }

  // A value, with the inputs it came from: those of what was read, and the one under way.
  Cell compute(const Term& term) {
    because_ = {};
    if (serial_ > 0) because_.insert(serial_);
    auto evaluation = evaluate();
    Cell cell{evaluation.value(term), {}};
    cell.because.assign(because_.begin(), because_.end());
    for (auto& application : evaluation.applications) events_.push_back(Applied{std::move(application), cell.because});
    if (evaluation.exhausted) events_.push_back(Trouble{fmt::format("evaluation of {} does not end", print(term))});
    return cell;
  }

  // Returns whether a rewrite ended the effects.
  bool perform(const std::vector<Effect>& effects) {
    for (const auto& effect : effects) {
      if (effect.when && !value(*effect.when).is_true()) continue;
      if (std::visit([this](const auto& what) { return perform_one(what); }, effect.what)) return true;
    }
    return false;
  }

  bool perform_one(const Say& say) {
    because_ = {};
    if (serial_ > 0) because_.insert(serial_);
    auto evaluation = evaluate();
    if (const auto words = fill_template(say.text, {}, evaluation))
      events_.push_back(continua::Said{*words, {because_.begin(), because_.end()}});
    return false;
  }
  bool perform_one(const Gesture& gesture) {
    auto cell = compute(gesture.term);
    if (!cell.value.is_null()) events_.push_back(Gestured{std::move(cell.value), std::move(cell.because)});
    return false;
  }
  bool perform_one(const Act& act) {
    auto cell = compute(act.term);
    if (!cell.value.is_null()) events_.push_back(Acted{std::move(cell.value), std::move(cell.because)});
    return false;
  }
  bool perform_one(const Remember& remember) {
    auto memory = configuration_.memory;
    for (const auto& [index, term] : remember.registers) {
      auto cell = compute(term);
      if (!(memory[index].value == cell.value)) events_.push_back(Remembered{index, cell.value});
      memory[index] = std::move(cell);
    }
    configuration_.memory = std::move(memory);
    return false;
  }
  bool perform_one(const Rewrite& rewrite) {
    if (!rewrite.operation.keeps_stack) {
      operate(rewrite.operation);
      events_.push_back(
          Rewrote{configuration_.state, &rewrite.operation, configuration_.stack.id(), configuration_.stack.depth()});
    }
    return true;
  }
  bool perform_one(const Group& group) { return perform(group.effects); }

  Stepper& stepper_;
  const Machine& machine_;
  Configuration configuration_;
  int serial_;
  Choice choice_;
  Random& random_;
  Term input_, target_, said_, confidence_, now_, in_state_;
  std::set<int> because_;
  std::vector<StepEvent> events_;
};

Step Stepper::begin(const Beliefs& beliefs, Choice choice, Random& random) {
  beliefs_ = &beliefs;
  Configuration configuration;
  configuration.state = machine_->start;
  configuration.stack = configuration.stack.push(bottom_symbol(*machine_), configuration.next_symbol++);
  configuration.history = configuration.history.entered(configuration.state, configuration.stack);
  for (const auto& entry : machine_->memory) configuration.memory.push_back({entry.initial, {}});
  const MadeSymbol bottom{configuration.stack.id(), std::nullopt, configuration.stack.top()};
  Run run(*this, std::move(configuration), nullptr, choice, random);
  if (machine_->epsilon_always) run.settle();
  Step step = std::move(run).done();
  step.events.insert(step.events.begin(), bottom);
  return step;
}

Step Stepper::step(const Configuration& before, const Input& input, const Beliefs& beliefs, Choice choice,
                   Random& random) {
  beliefs_ = &beliefs;
  Run run(*this, before, &input, choice, random);
  run.offer(input);
  return std::move(run).done();
}

Term Stepper::value(const Term& term, const Configuration& configuration, const Input& input, const Beliefs& beliefs) {
  beliefs_ = &beliefs;
  Random unused(0);
  Run run(*this, configuration, &input, Choice::likeliest, unused);
  return run.value(term);
}

}  // namespace continua
