#include "automaton/machine_loader.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "automaton/machine_reader.h"
#include "term/evaluate.h"

namespace continua {
namespace {

// Names of the moment that every term may read; FORMAT.md documents them.
const Signature& moment_signature() {
  static const Signature names = {
      {"input", Type::text_type()},
      {"target", Type::location()},
      {"said", Type::text_type()},
      {"confidence", Type::number()},
      {"now", Type::number()},
      {"in_state", Type::text_type()},
      {"is_input", Type::function(Type::text_type(), Type::truth())},
      {"certainty", Type::function(Type::text_type(), Type::number())},
      {"wording", Type::function(Type::term(), Type::text_type())},
  };
  return names;
}

Term empty_value(const Type& type) {
  return type.kind() == Type::Kind::list ? Term::list({}, type.element()) : Term::null();
}

}  // namespace

std::optional<Choice> parse_choice(std::string_view name) {
  for (const auto choice : {Choice::likeliest, Choice::sample, Choice::unique})
    if (text(choice) == name) return choice;
  return std::nullopt;
}

std::string text(Choice choice) {
  switch (choice) {
    case Choice::likeliest: return "likeliest";
    case Choice::sample: return "sample";
    case Choice::unique: return "unique";
  }
  return "";
}

bool Machine::knows_input(std::string_view symbol) const {
  return std::any_of(transitions.begin(), transitions.end(),
                     [&](const Transition& transition) { return transition.on && transition.on->contains(symbol); });
}

MachineReader::MachineReader(const LocatedJson& document, const Signature& methods)
    : document_(document), methods_(methods) {
  scope_ = term_signature();
  for (const auto* names : {&methods_, &moment_signature()}) scope_.insert(names->begin(), names->end());
}

Machine MachineReader::read() {
  const Item root{&document_.root(), ""};
  if (!expect_object(root, "a machine",
                     {"machine", "name", "about", "start", "accept", "choice", "epsilon", "rewrite_below",
                      "minimum_confidence", "repeat_utterances", "perspective", "programs", "slots", "memory", "inputs",
                      "define", "wordings", "beliefs", "states", "transitions", "examples", "$schema"}))
    return machine_;
  machine_.document = compact(document_.root());
  read_programs(member(root, "programs"));
  read_slots(member(root, "slots"));
  read_memory(member(root, "memory"));
  read_inputs(member(root, "inputs"));
  read_state_names(root);
  read_definitions(member(root, "define"));
  read_header(root);
  read_beliefs(member(root, "beliefs"));
  read_wordings(member(root, "wordings"));
  read_states(member(root, "states"));
  read_transitions(member(root, "transitions"));
  return machine_;
}

void MachineReader::read_header(const Item& root) {
  const auto version = member(root, "machine");
  if (!version.json || *version.json != 1) problem(version.json ? version : root, "expected \"machine\": 1, the version of the format");
  machine_.name = text_of(member(root, "name"), "the machine's name");
  const auto start = member(root, "start");
  if (start.json) machine_.start = state_named(start);
  else problem(root, "expected \"start\", the state in which a run begins");
  if (const auto accept = member(root, "accept"); accept.json && expect_array(accept, "the accepting states"))
    for (std::size_t i = 0; i < accept.json->size(); ++i) machine_.states[state_named(element(accept, i))].accepting = true;
  if (const auto choice = member(root, "choice"); choice.json) {
    const auto name = text_of(choice, "a policy");
    if (const auto policy = parse_choice(name)) machine_.choice = *policy;
    else problem(choice, fmt::format("unknown policy '{}'; expected likeliest, sample or unique", name));
  }
  if (const auto epsilon = member(root, "epsilon"); epsilon.json) {
    const auto when = text_of(epsilon, "when ε-transitions are tried");
    if (when != "always" && when != "after_rewrite")
      problem(epsilon, fmt::format("'{}' is not when ε-transitions are tried; expected always or after_rewrite", when));
    machine_.epsilon_always = when == "always";
  }
  machine_.rewrite_below = truth_of(member(root, "rewrite_below"), "rewrite_below", false);
  machine_.repeats_utterances = truth_of(member(root, "repeat_utterances"), "repeat_utterances", true);
  machine_.minimum_confidence = number_of(member(root, "minimum_confidence"), "minimum_confidence", 0);
  if (const auto perspective = member(root, "perspective"); perspective.json) {
    machine_.perspective = text_of(perspective, "a perspective");
    if (machine_.perspective != "human" && machine_.perspective != "avatar")
      problem(perspective, fmt::format("unknown perspective '{}'; expected human or avatar", machine_.perspective));
  }
}

Type MachineReader::read_type(const Item& item) {
  auto type = Type::parse(text_of(item, "a type"));
  if (type) return *type;
  problem(item, type.error().text());
  return Type::term();
}

void MachineReader::declare(const Item& at, const std::string& name, const Type& type) {
  if (!scope_.emplace(name, type).second) problem(at, fmt::format("the name '{}' is taken already", name));
}

void MachineReader::read_programs(const Item& programs) {
  if (!programs.json || !expect_object(programs, "programs")) return;
  for (const auto& [name, value] : programs.json->items()) {
    const auto item = member(programs, name);
    const auto type = read_type(item);
    machine_.programs.emplace(name, type);
    declare(item, name, type);
  }
}

void MachineReader::read_slots(const Item& slots) {
  if (!slots.json || !expect_object(slots, "slots")) return;
  for (const auto& [name, value] : slots.json->items()) {
    const auto item = member(slots, name);
    Slot slot{name, Type::term(), false};
    if (value.is_object()) {
      expect_object(item, "a slot", {"type", "persists", "about"});
      slot.type = read_type(member(item, "type"));
      slot.persists = truth_of(member(item, "persists"), "persists", false);
    } else {
      slot.type = read_type(item);
    }
    declare(item, name, slot.type);
    machine_.slot_index.emplace(name, machine_.slots.size());
    machine_.slots.push_back(std::move(slot));
  }
}

void MachineReader::read_memory(const Item& memory) {
  if (!memory.json || !expect_object(memory, "memory")) return;
  for (const auto& [name, value] : memory.json->items()) {
    const auto item = member(memory, name);
    if (!expect_object(item, "a register", {"type", "initial", "about"})) continue;
    Register entry{name, read_type(member(item, "type")), Term::null()};
    entry.initial = empty_value(entry.type);
    if (const auto initial = member(item, "initial"); initial.json)
      if (const auto term = parse(initial, entry.type)) entry.initial = *term;
    declare(item, name, entry.type);
    machine_.register_index.emplace(name, machine_.memory.size());
    machine_.memory.push_back(std::move(entry));
  }
}

void MachineReader::read_inputs(const Item& inputs) {
  if (!inputs.json || !expect_object(inputs, "inputs")) return;
  for (const auto& [name, value] : inputs.json->items()) {
    std::vector<std::string> path;
    named_set(inputs, name, path);
  }
}

// A set may name other sets; `path` holds the names that are being read, to find one that contains itself.
const SymbolSet& MachineReader::named_set(const Item& inputs, const std::string& name, std::vector<std::string>& path) {
  if (const auto known = sets_.find(name); known != sets_.end()) return known->second;
  const auto item = member(inputs, name);
  SymbolSet set;
  if (std::find(path.begin(), path.end(), name) != path.end()) {
    problem(item, fmt::format("the set '{}' contains itself", name));
  } else if (expect_array(item, "a set of input symbols")) {
    path.push_back(name);
    for (std::size_t i = 0; i < item.json->size(); ++i) {
      const auto symbol = text_of(element(item, i), "an input symbol");
      if (inputs.json->contains(symbol)) set.add(named_set(inputs, symbol, path));
      else set.add(symbol);
    }
    path.pop_back();
  }
  return sets_.emplace(name, std::move(set)).first->second;
}

SymbolSet MachineReader::read_symbols(const Item& item) {
  SymbolSet set;
  const auto add = [&](const Item& one) {
    const auto symbol = text_of(one, "an input symbol or the name of a set");
    if (const auto named = sets_.find(symbol); named != sets_.end()) set.add(named->second);
    else set.add(symbol);
  };
  if (item.json && item.json->is_array())
    for (std::size_t i = 0; i < item.json->size(); ++i) add(element(item, i));
  else
    add(item);
  return set;
}

// States are known before transitions are read: those declared, then those transitions lead from or to.
void MachineReader::read_state_names(const Item& root) {
  const auto add = [&](const Json& name) {
    if (name.is_string() && name != "*" && state_index_.emplace(name.get<std::string>(), machine_.states.size()).second)
      machine_.states.push_back({name.get<std::string>(), false, std::nullopt, {}});
  };
  if (const auto states = member(root, "states"); states.json && states.json->is_object())
    for (const auto& [name, value] : states.json->items()) add(Json(name));
  const auto transitions = member(root, "transitions");
  if (!transitions.json || !transitions.json->is_array()) return;
  for (const auto& transition : *transitions.json) {
    if (!transition.is_object()) continue;
    if (const auto from = transition.find("from"); from != transition.end()) {
      if (from->is_array()) for (const auto& name : *from) add(name);
      else add(*from);
    }
    if (const auto to = transition.find("to"); to != transition.end()) add(*to);
  }
}

StateIndex MachineReader::state_named(const Item& item) {
  const auto name = text_of(item, "a state");
  if (const auto found = state_index_.find(name); found != state_index_.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& state : machine_.states) known.push_back(state.name);
  if (!name.empty()) problem(item, fmt::format("unknown state '{}'{}", name, did_you_mean(name, known)));
  if (machine_.states.empty()) machine_.states.push_back({name, false, std::nullopt, {}});
  return 0;
}

void MachineReader::read_states(const Item& states) {
  if (!states.json || !expect_object(states, "states")) return;
  for (const auto& [name, value] : states.json->items()) {
    const auto item = member(states, name);
    if (!expect_object(item, "a state", {"gate", "enter", "about", "layout"})) continue;
    auto& state = machine_.states[state_index_.at(name)];
    if (const auto gate = member(item, "gate"); gate.json) {
      if (!expect_object(gate, "a gate", {"when", "else", "push", "push_each", "pop", "rewrite", "rewrite_each", "flush", "pop_until", "none", "about"}))
        continue;
      const auto when = parse(member(gate, "when"), Type::truth());
      const auto otherwise = state_named(member(gate, "else"));
      if (when) state.gate = Gate{*when, otherwise, read_operation(gate)};
    }
    if (const auto enter = member(item, "enter"); enter.json) state.enter = read_effects(enter);
  }
}

void MachineReader::read_transitions(const Item& transitions) {
  if (!transitions.json) return problem({&document_.root(), ""}, "expected \"transitions\", a list");
  if (!expect_array(transitions, "the transitions")) return;
  std::set<std::string> ids;
  for (std::size_t i = 0; i < transitions.json->size(); ++i) {
    const auto item = element(transitions, i);
    const auto before = machine_.transitions.size();
    read_transition(item);
    if (machine_.transitions.size() > before && !ids.insert(machine_.transitions.back().id).second)
      problem(member(item, "id"), fmt::format("a second transition with the id '{}'", machine_.transitions.back().id));
  }
  machine_.leaving.resize(machine_.states.size());
  for (std::size_t i = 0; i < machine_.transitions.size(); ++i)
    for (const auto from : machine_.transitions[i].from) machine_.leaving[from].push_back(i);
}

void MachineReader::read_transition(const Item& item) {
  if (!expect_object(item, "a transition",
                     {"id", "from", "on", "when", "to", "push", "push_each", "pop", "rewrite", "rewrite_each", "flush",
                      "pop_until", "none", "weight", "do", "about"}))
    return;
  Transition transition;
  transition.id = text_of(member(item, "id"), "the transition's id");
  const auto from = member(item, "from");
  if (from.json && *from.json == "*") {
    for (StateIndex i = 0; i < machine_.states.size(); ++i) transition.from.push_back(i);
  } else if (from.json && from.json->is_array()) {
    for (std::size_t i = 0; i < from.json->size(); ++i) transition.from.push_back(state_named(element(from, i)));
  } else {
    transition.from.push_back(state_named(from.json ? from : item));
  }
  const auto on = member(item, "on");
  if (!on.json) problem(item, "expected \"on\": input symbols, or null for an ε-transition");
  else if (!on.json->is_null()) transition.on = read_symbols(on);
  if (on.json && !on.json->is_null()) transition.on_text = on.json->is_string() ? on.json->get<std::string>() : compact(*on.json);
  if (const auto when = member(item, "when"); when.json) transition.when = parse(when, Type::truth());
  transition.to = state_named(member(item, "to"));
  transition.operation = read_operation(item);
  transition.weight = number_of(member(item, "weight"), "a weight", 1);
  if (!(transition.weight > 0)) problem(member(item, "weight"), "a weight is greater than 0");
  if (const auto effects = member(item, "do"); effects.json) transition.effects = read_effects(effects);
  machine_.transitions.push_back(std::move(transition));
}

Item MachineReader::member(const Item& object, const std::string& key) const {
  if (!object.json || !object.json->is_object()) return {nullptr, object.pointer};
  const auto found = object.json->find(key);
  if (found == object.json->end()) return {nullptr, object.pointer};
  std::string escaped;
  for (const char c : key) escaped += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
  return {&*found, object.pointer + "/" + escaped};
}

Item MachineReader::element(const Item& array, std::size_t index) const {
  return {&(*array.json)[index], array.pointer + "/" + std::to_string(index)};
}

bool MachineReader::expect_object(const Item& item, const char* what, std::initializer_list<const char*> keys) {
  if (!item.json || !item.json->is_object()) {
    problem(item, fmt::format("expected {}, an object{}", what, item.json ? ", found " + std::string(item.json->type_name()) : ""));
    return false;
  }
  if (keys.size() == 0) return true;
  const std::vector<std::string> known(keys.begin(), keys.end());
  for (const auto& [key, value] : item.json->items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      problem(member(item, key), fmt::format("unknown key '{}' of {}{}", key, what, did_you_mean(key, known)));
  return true;
}

bool MachineReader::expect_array(const Item& item, const char* what) {
  if (item.json && item.json->is_array()) return true;
  problem(item, fmt::format("expected {}, a list{}", what, item.json ? ", found " + std::string(item.json->type_name()) : ""));
  return false;
}

std::string MachineReader::text_of(const Item& item, const char* what) {
  if (item.json && item.json->is_string()) return item.json->get<std::string>();
  problem(item, fmt::format("expected {}, a string{}", what, item.json ? ", found " + std::string(item.json->type_name()) : ""));
  return {};
}

double MachineReader::number_of(const Item& item, const char* what, double otherwise) {
  if (!item.json) return otherwise;
  if (item.json->is_number()) return item.json->get<double>();
  problem(item, fmt::format("expected {}, a number, found {}", what, item.json->type_name()));
  return otherwise;
}

bool MachineReader::truth_of(const Item& item, const char* what, bool otherwise) {
  if (!item.json) return otherwise;
  if (item.json->is_boolean()) return item.json->get<bool>();
  problem(item, fmt::format("expected {}, true or false, found {}", what, item.json->type_name()));
  return otherwise;
}

void MachineReader::problem(const Item& at, std::string sentence) {
  problems.push_back(document_.error(at.pointer, std::move(sentence)));
}

Result<Machine> parse_machine(std::string_view text, const std::string& name, const Signature& methods) {
  auto document = LocatedJson::parse(text, name);
  if (!document) return document.error();
  MachineReader reader(*document, methods);
  auto machine = reader.read();
  if (!reader.problems.empty()) return reader.problems.front();
  return machine;
}

Result<Machine> load_machine(const std::string& path, const Signature& methods) {
  auto text = read_file(path);
  if (!text) return text.error();
  return parse_machine(*text, path, methods);
}

std::vector<Error> check_machine(std::string_view text, const std::string& name, const Signature& methods) {
  auto document = LocatedJson::parse(text, name);
  if (!document) return {document.error()};
  MachineReader reader(*document, methods);
  reader.read();
  return std::move(reader.problems);
}

}  // namespace continua
