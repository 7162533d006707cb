#include "continua/automaton/firing.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/automaton/condition.h"
#include "continua/automaton/looked.h"
#include "continua/automaton/stack_operation.h"
#include "continua/automaton/wording.h"
#include "continua/term/raising.h"

namespace continua {
namespace {

// The sources that a register takes over with a value that it has already: no record tells of that. Where there are
// more the register keeps those that it had, so that they do not grow with the session.
constexpr std::size_t most_untold = 16;

void add(int source, std::vector<int>& into) {
  const auto place = std::lower_bound(into.begin(), into.end(), source);
  if (place == into.end() || *place != source) into.insert(place, source);
}

void add(const std::vector<int>& sources, std::vector<int>& into) {
  for (const int source : sources) add(source, into);
}

// The sources of the values that are new in the symbol.
std::vector<int> sources_of_new(const Symbol& symbol, int id) {
  std::vector<int> because;
  for (const auto& cell : symbol)
    if (cell.source == source_of_symbol(id)) add(cell.because, because);
  return because;
}

}  // namespace

Applicable Firing::applicable() {
  Applicable found;
  const auto& exits = machine_.exits[configuration_.state];
  std::size_t alternative = 0;
  do {
    const auto first = found.candidates.size();
    if (inputs_.size() > 1) take_input(alternative);
    const auto* takers = input_ ? exits.on(input_->symbol) : &exits.epsilon;
    const bool may_take = !takers;  // no transition names the symbol; some may take it by prefix
    for (const auto index : may_take ? exits.by_prefix : *takers) {
      const auto& transition = machine_.transitions[index];
      if (may_take && !transition.on->contains(input_->symbol)) continue;
      const double weight = transition.weight * (input_ ? input_->confidence : 1);
      if (!(weight > 0)) continue;
      if (!transition.when) {
        found.candidates.push_back({index, weight, alternative});
        continue;
      }
      auto evaluation = evaluate();
      if (holds(*transition.when, evaluation))
        found.candidates.push_back({index, weight, alternative});
      else if (account_)
        found.refused.push_back({index, why_not(*transition.when, machine_, evaluation), alternative});
      found.margin = std::min(found.margin, evaluation.margin);
    }
    part_by_rank(found, first);
  } while (++alternative < inputs_.size());
  return found;
}

// Candidates from `first` on take the same input; those of the highest rank stay.
void Firing::part_by_rank(Applicable& found, std::size_t first) {
  const auto begin = found.candidates.begin() + static_cast<std::ptrdiff_t>(first);
  const auto rank = [&](const Candidate& one) { return machine_.transitions[one.transition].rank; };
  const auto highest =
      std::max_element(begin, found.candidates.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
  if (highest == found.candidates.end()) return;
  const Candidate best = *highest;
  const auto lower = std::stable_partition(begin, found.candidates.end(),
                                           [&](const Candidate& one) { return rank(one) == rank(best); });
  if (lower == found.candidates.end()) return;
  for (auto one = lower; account_ && one != found.candidates.end(); ++one)
    found.refused.push_back({one->transition,
                             fmt::format("'{}' applies too, of rank {} against {}",
                                         machine_.transitions[best.transition].id, rank(best), rank(*one)),
                             one->alternative, best.transition});
  found.outranked.insert(found.outranked.end(), lower, found.candidates.end());
  found.candidates.erase(lower, found.candidates.end());
  std::stable_sort(found.refused.begin(), found.refused.end(), [](const Refused& a, const Refused& b) {
    return std::pair(a.alternative, a.transition) < std::pair(b.alternative, b.transition);
  });
}

std::optional<Entry> Firing::entry(const Transition& transition) {
  Entry entry{transition.to, &transition.operation, false, {}};
  std::vector<StateIndex> refused;
  while (const auto& gate = machine_.states[entry.state].gate) {
    if (std::find(refused.begin(), refused.end(), entry.state) != refused.end()) return std::nullopt;
    auto evaluation = evaluate();
    const bool passed = holds(gate->when, evaluation);
    entry.margin = std::min(entry.margin, evaluation.margin);
    entry.gates.push_back({entry.state, account_ ? print(gate->when) : "", passed});
    if (passed) break;
    refused.push_back(entry.state);
    entry.state = gate->otherwise;
    entry.operation = &gate->operation;
    entry.rejected = true;
  }
  return entry;
}

std::optional<bool> Firing::fire(const Chosen& chosen, Applicable found, int step) {
  if (inputs_.size() > 1) take_input(chosen.alternative);
  const auto& transition = machine_.transitions[chosen.transition];
  auto where = entry(transition);
  if (!where) {
    note(Trouble{fmt::format("the gates that {} leads to refuse one another in a circle", transition.id)});
    return std::nullopt;
  }
  apply(change(*where->operation));
  if (account_)
    note(Fired{chosen.transition, step, configuration_.state, where->state,
               input_ ? std::optional(input_->symbol) : std::nullopt, where->operation, std::move(found.candidates),
               std::move(found.refused), std::move(where->gates), chosen.probability, chosen.draw, chosen.forced,
               configuration_.stack.id(), configuration_.stack.depth(), std::min(found.margin, where->margin),
               chosen.alternative, inputs_.size()});
  bool settles = machine_.epsilon_always || where->operation->is_rewrite();
  if (!where->rejected && perform_and_rewrite(transition.effects)) settles = true;
  enter(where->state);
  if (perform_and_rewrite(machine_.states[where->state].enter)) settles = true;
  return settles;
}

void Firing::enter(StateIndex state) {
  configuration_.state = state;
  if (machine_.landmarks > 0)
    configuration_.history =
        configuration_.history.entered(machine_.landmark[state], machine_.landmarks, configuration_.stack);
}

void Firing::take_input(std::size_t alternative) {
  input_ = &inputs_[alternative];
  origin_.sources = input_->because;
  if (input_->serial > 0) origin_.sources.push_back(input_->serial);
  std::sort(origin_.sources.begin(), origin_.sources.end());
  origin_.sources.erase(std::unique(origin_.sources.begin(), origin_.sources.end()), origin_.sources.end());
  origin_.now_s = input_->now_s;
}

void Firing::forget_input() {
  inputs_ = {};
  input_ = nullptr;
}

Change Firing::change(const Operation& operation) {
  Change change{&operation, {}};
  for (const auto& content : operation.contents) {
    if (!content.term) {
      change.contents.push_back(std::nullopt);
      continue;
    }
    const auto& slot = machine_.slots[content.slot];
    const bool each = operation.kind == Operation::Kind::push_each || operation.kind == Operation::Kind::rewrite_each;
    change.contents.push_back(of_type(each ? Type::list(slot.type) : slot.type, slot.name, derived(*content.term)));
  }
  return change;
}

// A value, or each element of a list, lifted to the type by the raising rules; each is an application for the account.
std::optional<Term> Firing::lifted(const Type& type, const Cell& cell) {
  if (!rules_.raising()) return std::nullopt;
  if (type.kind() == Type::Kind::list && cell.value.kind() == Term::Kind::list) {
    std::vector<Term> elements;
    for (const auto& each : cell.value.elements()) {
      const auto element =
          fits(each, type.element()) ? std::optional(each) : lifted(type.element(), {each, cell.because});
      if (!element) return std::nullopt;
      elements.push_back(*element);
    }
    return Term::list(std::move(elements), type.element());
  }
  auto evaluation = evaluate();
  const auto up = raised(cell.value, type, *rules_.raising(), evaluation);
  if (!up) return std::nullopt;
  const auto rule = std::find_if(rules_.raising()->begin(), rules_.raising()->end(),
                                 [&](const RaisingRule& each) { return each.name == up->rule; });
  note(Applied{{rule->by, cell.value, up->term, up->rule}, cell.because});
  return up->term;
}

// Lifts the value to the slot's type, or empties the cell if no rule can. A slot of type `term` takes every value.
Cell Firing::of_type(const Type& type, const std::string& name, Cell cell) {
  if (fits(cell.value, type)) return cell;
  if (auto up = lifted(type, cell)) return {*std::move(up), std::move(cell.because)};
  note(Trouble{
      fmt::format("{} is no {}, and {} takes no other: it is left empty", print(cell.value), type.text(), name)});
  return {empty_value(type), std::move(cell.because)};
}

// Performs an operation on the stack. New symbols go to the account first.
void Firing::apply(const Change& change) {
  if (change.operation->kind == Operation::Kind::none) return;
  auto result = apply_operation(*change.operation, change.contents, machine_, configuration_);
  for (auto& made : result.made)
    note(MadeSymbol{made.id(), made.id_below(), made.top(), sources_of_new(made.top(), made.id())});
  if (!result.trouble.empty()) note(Trouble{std::move(result.trouble)});
  configuration_.stack = std::move(result.stack);
  configuration_.next.symbol = result.next_symbol;
  clear_registers(change.operation->kind);
}

// FLUSH and pop_until set the registers that the machine declares for them to their first values.
void Firing::clear_registers(Operation::Kind kind) {
  const bool flushes = kind == Operation::Kind::flush, pops = kind == Operation::Kind::pop_until;
  if (!flushes && !pops) return;
  std::optional<std::vector<Cell>> cleared;
  for (std::size_t i = 0; i < machine_.memory.size(); ++i) {
    const auto& one = machine_.memory[i];
    if (!(flushes ? one.cleared_by_flush : one.cleared_by_pop_until)) continue;
    if ((*configuration_.memory)[i].value == one.initial) continue;
    if (!cleared) cleared = *configuration_.memory;
    write_register(i, {one.initial, origin_.sources}, *cleared);
  }
  if (cleared) configuration_.memory = std::make_shared<const std::vector<Cell>>(*std::move(cleared));
}

void Firing::write_register(std::size_t index, Cell cell, std::vector<Cell>& memory) {
  const int number = configuration_.next.write++;
  cell.source = source_of_write(number);
  note(Remembered{index, cell.value, number, cell.because});
  memory[index] = std::move(cell);
}

bool Firing::perform_and_rewrite(const std::vector<Effect>& effects) {
  const auto rewrite = perform(effects);
  if (!rewrite) return false;
  if (!rewrite->operation->keeps_stack) {
    apply(*rewrite);
    note(Rewrote{configuration_.state, rewrite->operation, configuration_.stack.id(), configuration_.stack.depth()});
  }
  return true;
}

std::optional<Change> Firing::perform(const std::vector<Effect>& effects) {
  if (!perform_all(effects)) return std::nullopt;
  return std::move(rewrite_);
}

bool Firing::perform_all(const std::vector<Effect>& effects) {
  for (const auto& effect : effects) {
    auto condition = evaluate();
    if (effect.when && !holds(*effect.when, condition)) continue;
    if (std::visit([this](const auto& what) { return perform_one(what); }, effect.what)) return true;
  }
  return false;
}

bool Firing::perform_one(const Say& say) {
  if (!account_) return false;
  because_ = origin_.sources;
  for (const auto& one : say.cases) {
    auto condition = evaluate();
    if (one.when && !holds(*one.when, condition)) continue;
    Said said;
    std::vector<Application> applications;
    for (const auto& variant : one.variants) {
      auto evaluation = evaluate();
      evaluation.definitions_wait = true;
      auto words = fill_template(variant, {}, evaluation);
      if (!words) continue;
      said.variants.push_back(std::move(*words));
      if (applications.empty()) applications = std::move(evaluation.applications);
    }
    if (said.variants.empty()) break;
    said.text = said.variants.front();
    said.because = because_;
    for (auto& each : applications) note(Applied{std::move(each), because_});
    note(std::move(said));
    break;
  }
  return false;
}
bool Firing::perform_one(const Gesture& gesture) {
  if (!account_) return false;
  auto cell = compute(gesture.term);
  if (!cell.value.is_null()) note(Gestured{std::move(cell.value), std::move(cell.because)});
  return false;
}
bool Firing::perform_one(const Act& act) {
  if (!account_) return false;
  auto cell = derived(act.term);
  if (cell.value.kind() == Term::Kind::list) {
    for (const auto& each : cell.value.elements()) note(Acted{each, cell.because});
  } else if (!cell.value.is_null()) {
    note(Acted{std::move(cell.value), std::move(cell.because)});
  }
  return false;
}
bool Firing::perform_one(const Remember& remember) {
  auto memory = *configuration_.memory;
  for (const auto& [index, term] : remember.registers) {
    auto cell = of_type(machine_.memory[index].type, machine_.memory[index].name, derived(term));
    if (!(memory[index].value == cell.value))
      write_register(index, std::move(cell), memory);
    else if (cell.because.size() <= most_untold)
      memory[index] = std::move(cell);
  }
  configuration_.memory = std::make_shared<const std::vector<Cell>>(std::move(memory));
  return false;
}
bool Firing::perform_one(const Learn& learn) {
  if (!account_) return false;
  const auto name = compute(learn.name);
  auto value = compute(learn.value);
  if (name.value.kind() != Term::Kind::text || value.value.is_null()) return false;
  auto inputs = name.because;
  add(value.because, inputs);
  note(Taught{learn.of, name.value.text_value(), std::move(value.value), std::move(inputs), learn.fixed});
  return false;
}
bool Firing::perform_one(const Forget& forget) {
  if (!account_) return false;
  auto name = compute(forget.name);
  if (forget.of && name.value.kind() != Term::Kind::text) return false;
  note(Forgotten{forget.of, forget.of ? name.value.text_value() : "", Term::null(), std::move(name.because)});
  return false;
}
bool Firing::perform_one(const Attend& attend) {
  if (!account_) return false;
  auto number = compute(attend.number);
  if (number.value.kind() == Term::Kind::number)
    note(Reattended{static_cast<int>(number.value.number_value()), origin_.now_s.value_or(0),
                    std::move(number.because)});
  return false;
}
bool Firing::perform_one(const Rewrite& rewrite) {
  rewrite_ = rewrite.operation.keeps_stack ? Change{&rewrite.operation, {}} : change(rewrite.operation);
  return true;
}
bool Firing::perform_one(const Group& group) { return perform_all(group.effects); }

Cell Firing::compute(const Term& term) {
  because_ = origin_.sources;
  auto evaluation = evaluate();
  Cell cell{evaluation.value(term), {}};
  cell.because = because_;
  for (auto& application : evaluation.applications) note(Applied{std::move(application), cell.because});
  if (evaluation.exhausted) note(Trouble{fmt::format("evaluation of {} does not end", print(term))});
  return cell;
}

Cell Firing::derived(const Term& term) {
  if (!account_) return compute(term);
  Derivation derivation;
  derivation_ = &derivation;
  const auto before = account_->size();
  auto cell = compute(term);
  derivation_ = nullptr;
  std::vector<Application> filled;
  for (auto event = account_->begin() + static_cast<std::ptrdiff_t>(before); event != account_->end(); ++event)
    if (const auto* applied = std::get_if<Applied>(&*event)) filled.push_back(applied->application);
  for (auto& application : derivation.of(cell.value, filled))
    if (composed_.insert(application.result).second) note(Applied{std::move(application), cell.because});
  return cell;
}

void Firing::note(StepEvent event) {
  if (account_) account_->push_back(std::move(event));
}

Evaluation Firing::evaluate() {
  Evaluation evaluation(
      rules_, [this](Name name) { return look_up(name); }, facts_);
  evaluation.derivation = derivation_;
  return evaluation;
}

// Looks up a name and notes the sources of its value, which become the `because` of the evaluated content. The
// evaluation copies a value before it asks for the next, so `moment_` can hold one at a time. Slots and registers hold
// values, and a reading is what was said: it is kept, so that it means the same whenever it is understood.
Evaluation::Held Firing::look_up(Name name) {
  using From = Binding::From;
  const auto found = machine_.bindings.find(name);
  if (found == machine_.bindings.end()) return nullptr;
  const auto& binding = found->second;
  switch (binding.from) {
    case From::slot:
      return read(configuration_.stack.top()[binding.index]);
    case From::memory:
      return read((*configuration_.memory)[binding.index]);
    case From::definition:
      return &binding.definition;
    case From::in_state:
      return &(moment_ = Term::text(machine_.states[configuration_.state].name));
    case From::input:
      return &(moment_ = input_ ? Term::text(input_->symbol) : Term::null());
    case From::carried:
      moment_ = input_ ? input_->*binding.carried : Term::null();
      if (derivation_) derivation_->read(moment_);
      return {&moment_, binding.carried == &Input::reading};
    case From::confidence:
      return &(moment_ = input_ ? Term::number(input_->confidence) : Term::null());
    case From::looked_at:
      if (!facts_.looked) return &(moment_ = Term::null());
      add(facts_.looked->because, because_);
      return &(moment_ = facts_.looked->objects);
    case From::now:
      return &(moment_ = origin_.now_s ? Term::number(*origin_.now_s) : Term::null());
  }
  return nullptr;
}

Evaluation::Held Firing::read(const Cell& cell) {
  if (cell.source != 0)
    add(cell.source, because_);
  else
    add(cell.because, because_);
  if (derivation_) derivation_->read(cell.value);
  return {&cell.value, true};
}

}  // namespace continua
