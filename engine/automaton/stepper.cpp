#include "continua/automaton/stepper.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/automaton/stack_operation.h"
#include "continua/automaton/wording.h"

namespace continua {

namespace {

// The rules that a machine adds to the language: its inputs, beliefs, wordings and tables.
Rules own_rules(const std::shared_ptr<const Machine>& machine) {
  Rules rules;
  rules["is_input"] = {
      1, [machine](std::span<const Term> arguments, Evaluation&) {
        return Term::truth(arguments[0].kind() == Term::Kind::text && machine->knows_input(arguments[0].text_value()));
      }};
  rules["certainty"] = {1, [](std::span<const Term> arguments, Evaluation& evaluation) {
                          const auto* beliefs = evaluation.facts().beliefs;
                          return beliefs && arguments[0].kind() == Term::Kind::text
                                     ? Term::number(beliefs->certainty(arguments[0].text_value()))
                                     : Term::null();
                        }};
  rules["wording"] = {1, [machine](std::span<const Term> arguments, Evaluation& evaluation) {
                        const auto words = wording_of(arguments[0], machine->wordings, evaluation);
                        return words ? Term::text(*words) : Term::null();
                      }};
  for (const auto& [name, entries] : machine->tables)
    rules[name] = {1, [machine, &entries = entries](std::span<const Term> arguments, Evaluation& evaluation) {
                     if (arguments[0].kind() != Term::Kind::text) return Term::null();
                     const auto entry = entries.find(arguments[0].text_value());
                     return entry == entries.end() ? Term::null() : evaluation.value(entry->second);
                   }};
  return rules;
}

RuleTable all_rules(const std::shared_ptr<const Machine>& machine, const Rules& facts, const RaisingRules* raising) {
  const Rules own = own_rules(machine);
  return RuleTable({&term_rules(), &facts, &own}, raising);
}

}  // namespace

Stepper::Stepper(std::shared_ptr<const Machine> machine, const Rules& facts, const RaisingRules* raising)
    : machine_(std::move(machine)), rules_(all_rules(machine_, facts, raising)) {}

Firing Stepper::firing(Configuration configuration, std::span<const Input> inputs, const Facts& facts,
                       std::vector<StepEvent>* account) const {
  return {*machine_, rules_, std::move(configuration), inputs, facts, account};
}

Configuration Stepper::initial() const {
  Configuration configuration;
  std::vector<Cell> memory;
  for (const auto& entry : machine_->memory) memory.push_back({entry.initial, {}});
  configuration.memory = std::make_shared<const std::vector<Cell>>(std::move(memory));
  configuration.state = machine_->start;
  configuration.stack = configuration.stack.push(bottom_symbol(*machine_), configuration.next.symbol++);
  if (machine_->landmarks > 0)
    configuration.history =
        configuration.history.entered(machine_->landmark[machine_->start], machine_->landmarks, configuration.stack);
  return configuration;
}

Step Stepper::begin(const Facts& facts, Chooser& chooser) const {
  Step step;
  auto configuration = initial();
  step.events.push_back(MadeSymbol{configuration.stack.id(), std::nullopt, configuration.stack.top()});
  auto firing = this->firing(std::move(configuration), std::span<const Input>(), facts, &step.events);
  if (machine_->epsilon_always) settle(firing, chooser, &step.events);
  step.after = std::move(firing).take();
  return step;
}

Step Stepper::step(const Configuration& before, std::span<const Input> inputs, const Facts& facts,
                   Chooser& chooser) const {
  Step step;
  auto firing = this->firing(before, inputs, facts, &step.events);
  offer(firing, inputs, chooser, &step.events);
  step.after = std::move(firing).take();
  return step;
}

std::optional<Configuration> Stepper::advance(const Configuration& before, std::span<const Input> inputs,
                                              const Facts& facts, Chooser& chooser) const {
  auto firing = this->firing(before, inputs, facts, nullptr);
  if (!offer(firing, inputs, chooser, nullptr)) return std::nullopt;
  return std::move(firing).take();
}

Configuration Stepper::implied(const Implied& row, const Configuration& before, const Input& input, const Facts& facts,
                               std::vector<StepEvent>* account) const {
  auto firing = this->firing(before, &input, facts, account);
  std::vector<Change> changes;
  for (const auto& operation : row.operations) changes.push_back(firing.change(operation));
  for (const auto& change : changes) firing.apply(change);
  firing.enter(row.to);
  return std::move(firing).take();
}

Cell Stepper::value(const Term& term, const Configuration& configuration, const Input& input,
                    const Facts& facts) const {
  return firing(configuration, &input, facts, nullptr).compute(term);
}

bool Stepper::offer(Firing& firing, std::span<const Input> inputs, Chooser& chooser,
                    std::vector<StepEvent>* account) const {
  require(!inputs.empty(), "an input is offered");
  auto found = firing.applicable();
  const auto chosen = chooser.choose(found.candidates, found.outranked, firing.configuration(), inputs);
  const auto state = firing.configuration().state;
  if (!chosen) {
    if (account) account->push_back(refusal(*machine_, state, std::move(found), inputs));
    return false;
  }
  const auto settles = firing.fire(*chosen, std::move(found), chooser.steps);
  if (!settles) {
    if (account)
      account->push_back(RefusedInput{state,
                                      inputs[chosen->alternative].symbol,
                                      fmt::format("the gates that {} leads to refuse one another in a circle",
                                                  machine_->transitions[chosen->transition].id),
                                      {},
                                      inputs.size()});
    return false;
  }
  firing.forget_input();
  if (*settles) settle(firing, chooser, account);
  return true;
}

// Fires ε-transitions until none applies. A machine that comes back to a configuration without a draw on the way would
// go round for ever, so the step ends with Trouble.
void Stepper::settle(Firing& firing, Chooser& chooser, std::vector<StepEvent>* account) const {
  std::vector<Configuration> seen;
  std::vector<std::size_t> path;  // path[i] is the transition that led away from seen[i]
  const auto id = [&](std::size_t transition) { return machine_->transitions[transition].id; };
  const auto trouble = [&](std::string message) {
    if (account) account->push_back(Trouble{std::move(message), true});
  };
  std::size_t free_from = 0;  // no draw was made since this step
  for (;;) {
    auto found = firing.applicable();
    const auto chosen = chooser.choose(found.candidates, found.outranked, firing.configuration(), {});
    if (!chosen) return;
    if (path.size() == most_epsilon_steps)
      return trouble(
          fmt::format("more than {} ε-transitions in a row, the last of them {}", most_epsilon_steps, id(path.back())));
    const auto back =
        std::find_if(seen.begin() + static_cast<std::ptrdiff_t>(free_from), seen.end(),
                     [&](const Configuration& earlier) { return earlier.same_as(firing.configuration()); });
    if (back != seen.end()) {
      std::vector<std::string> cycle;
      for (auto at = static_cast<std::size_t>(back - seen.begin()); at < path.size(); ++at)
        cycle.push_back(id(path[at]));
      return trouble(fmt::format("an ε-cycle that changes nothing: {}", fmt::join(cycle, ", ")));
    }
    seen.push_back(firing.configuration());
    path.push_back(chosen->transition);
    if (chosen->draw) free_from = seen.size();
    const auto settles = firing.fire(*chosen, std::move(found), chooser.steps);
    if (!settles || !*settles) return;
  }
}

RefusedInput refusal(const Machine& machine, StateIndex state, Applicable found, std::span<const Input> inputs) {
  const auto reason = [&](std::size_t alternative) -> std::string {
    std::vector<std::string> ids;
    for (const auto& candidate : found.candidates)
      if (candidate.alternative == alternative) ids.push_back(machine.transitions[candidate.transition].id);
    if (ids.size() > 1) return fmt::format("more than one transition applies: {}", fmt::join(ids, ", "));
    if (ids.size() == 1) return fmt::format("{} applies, but another input is not unique", ids.front());
    if (std::any_of(found.refused.begin(), found.refused.end(),
                    [&](const Refused& one) { return one.alternative == alternative; }))
      return "no transition's condition holds";
    const auto& input = inputs[alternative];
    if (!(input.confidence > 0)) return "its confidence is 0";
    return fmt::format("no transition from {} takes '{}'", machine.states[state].name, input.symbol);
  };
  std::vector<std::string> reasons;
  for (std::size_t i = 0; i < inputs.size(); ++i)
    reasons.push_back(inputs.size() == 1 ? reason(i) : fmt::format("'{}': {}", inputs[i].symbol, reason(i)));
  return {state, inputs.front().symbol, fmt::format("{}", fmt::join(reasons, "; ")), std::move(found.refused),
          inputs.size()};
}

}  // namespace continua
