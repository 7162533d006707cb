#include <cmath>

#include "continua/replay/recorder/record_of.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

bool is_empty(const Term& term) {
  return term.is_null() || (term.kind() == Term::Kind::list && term.elements().empty());
}

// Alternatives are told apart only where there are several.
std::optional<std::int64_t> alternative_of(std::size_t alternative, std::size_t alternatives) {
  return alternatives > 1 ? std::optional<std::int64_t>(alternative) : std::nullopt;
}

std::vector<log::Refused> refusals_of(const std::vector<Refused>& refused, std::size_t alternatives,
                                      const Machine& machine) {
  std::vector<log::Refused> records;
  for (const auto& each : refused) {
    log::Refused record{machine.transitions[each.transition].id, each.reason,
                        alternative_of(each.alternative, alternatives), std::nullopt};
    if (each.outranked_by) record.outranked_by = machine.transitions[*each.outranked_by].id;
    records.push_back(std::move(record));
  }
  return records;
}

std::optional<std::vector<std::int64_t>> unless_empty(const std::vector<int>& because, const SourceRecords& sources) {
  auto records = records_of(because, sources);
  return records.empty() ? std::nullopt : std::optional(std::move(records));
}

}  // namespace

log::Belief record_of(const BeliefChange& change) { return {change.name, change.value, change.was}; }

log::Memory record_of(const Remembered& remembered, const Machine& machine, const SourceRecords& sources) {
  return {machine.memory[remembered.index].name, print(remembered.value), unless_empty(remembered.because, sources)};
}

log::Transition record_of(const Fired& fired, const Machine& machine) {
  const auto& transition = machine.transitions[fired.transition];
  log::Transition record;
  record.id = transition.id;
  record.step = fired.step;
  record.from = machine.states[fired.from].name;
  record.to = machine.states[fired.to].name;
  record.input = fired.input;
  record.operation = Json::parse(fired.operation->source);
  record.weight = transition.weight;
  record.probability = fired.probability;
  record.draw = fired.draw;
  record.forced = fired.forced;
  for (const auto& each : fired.candidates)
    record.candidates.push_back(
        {machine.transitions[each.transition].id, each.weight, alternative_of(each.alternative, fired.alternatives)});
  record.refused = refusals_of(fired.refused, fired.alternatives, machine);
  for (const auto& gate : fired.gates)
    record.gates.push_back({machine.states[gate.state].name, gate.condition, gate.passed});
  record.stack = fired.stack;
  record.depth = static_cast<std::int64_t>(fired.depth);
  if (std::isfinite(fired.margin)) record.margin = log::Margin(fired.margin);
  record.alternative = alternative_of(fired.alternative, fired.alternatives);
  return record;
}

log::Branches record_of(const Explored& explored, const Machine& machine) {
  log::Branches record;
  for (const auto& branch : explored.branches) {
    const auto& stack = branch.configuration.stack;
    log::Branch each;
    each.id = branch.id;
    each.parent = branch.parent;
    each.state = machine.states[branch.configuration.state].name;
    each.stack = stack.id();
    each.depth = static_cast<std::int64_t>(stack.depth());
    each.weight = branch.weight;
    each.settled = branch.settled;
    for (const auto transition : branch.by) each.by.push_back(machine.transitions[transition].id);
    record.branches.push_back(std::move(each));
  }
  record.dropped.assign(explored.dropped.begin(), explored.dropped.end());
  record.merged = explored.merged;
  record.pruned = explored.pruned;
  return record;
}

log::Correction record_of(const Corrected& corrected, const Machine& machine) {
  log::Correction record;
  record.id = "observed";
  record.from = machine.states[corrected.from].name;
  record.to = machine.states[corrected.to].name;
  if (corrected.implied) record.implied = static_cast<std::int64_t>(corrected.implied);
  record.stack = corrected.stack;
  record.depth = static_cast<std::int64_t>(corrected.depth);
  return record;
}

log::Symbol record_of(const MadeSymbol& made, const Machine& machine, const SourceRecords& sources) {
  log::Symbol record;
  record.id = made.id;
  if (made.below) record.below = *made.below;
  for (std::size_t i = 0; i < made.symbol.size(); ++i)
    if (const auto& value = made.symbol[i].value; !is_empty(value))
      record.slots.emplace_back(machine.slots[i].name, print(value));
  record.because = unless_empty(made.because, sources);
  return record;
}

log::Rewrite record_of(const Rewrote& rewrote, const Machine& machine) {
  return {machine.states[rewrote.state].name, Json::parse(rewrote.operation->source), rewrote.stack,
          static_cast<std::int64_t>(rewrote.depth)};
}

log::Application record_of(const Applied& applied, const SourceRecords& sources) {
  const auto& [function, argument, result, rule] = applied.application;
  log::Application record;
  record.function = print(function);
  record.argument = print(argument);
  record.result = print(result);
  record.types = {function.type().text(), argument.type().text(), result.type().text()};
  if (!rule.empty()) record.rule = rule;
  record.because = records_of(applied.because, sources);
  return record;
}

log::Refusal record_of(const RefusedInput& refused, const Machine& machine) {
  return {machine.states[refused.state].name, refused.input, refused.reason,
          refusals_of(refused.refused, refused.alternatives, machine)};
}

log::Problem record_of(const Trouble& trouble) { return {std::nullopt, trouble.message}; }

}  // namespace continua
