// Walking a machine file: its header, what it declares, and the shapes of JSON.
#include "automaton/machine_reader.h"

#include <fmt/format.h>

#include <algorithm>

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

}  // namespace

MachineReader::MachineReader(const LocatedJson& document, const Signature& methods)
    : document_(document), methods_(methods) {
  scope_ = term_signature();
  for (const auto* names : {&methods_, &moment_signature()}) scope_.insert(names->begin(), names->end());
}

Machine MachineReader::read() {
  const Item root{&document_.root(), ""};
  if (!expect_object(root, "a machine",
                     {"machine",
                      "name",
                      "about",
                      "start",
                      "accept",
                      "choice",
                      "epsilon",
                      "rewrite_below",
                      "minimum_confidence",
                      "repeat_utterances",
                      "perspective",
                      "programs",
                      "slots",
                      "memory",
                      "inputs",
                      "define",
                      "wordings",
                      "beliefs",
                      "states",
                      "transitions",
                      "examples",
                      "$schema"}))
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
  machine_.index();
  return machine_;
}

void MachineReader::read_header(const Item& root) {
  const auto version = member(root, "machine");
  if (!version.json || *version.json != 1)
    problem(version.json ? version : root, "expected \"machine\": 1, the version of the format");
  machine_.name = text_of(member(root, "name"), "the machine's name");
  const auto start = member(root, "start");
  if (start.json)
    machine_.start = state_named(start);
  else
    problem(root, "expected \"start\", the state in which a run begins");
  if (const auto accept = member(root, "accept"); accept.json && expect_array(accept, "the accepting states"))
    for (std::size_t i = 0; i < accept.json->size(); ++i)
      machine_.states[state_named(element(accept, i))].accepting = true;
  if (const auto choice = member(root, "choice"); choice.json) {
    const auto name = text_of(choice, "a policy");
    if (const auto policy = parse_choice(name))
      machine_.choice = *policy;
    else
      problem(choice, fmt::format("unknown policy '{}'; expected {}", name, choice_names()));
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
    problem(item, fmt::format("expected {}, an object{}", what,
                              item.json ? ", found " + std::string(item.json->type_name()) : ""));
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
  problem(item, fmt::format("expected {}, a list{}", what,
                            item.json ? ", found " + std::string(item.json->type_name()) : ""));
  return false;
}

std::string MachineReader::text_of(const Item& item, const char* what) {
  if (item.json && item.json->is_string()) return item.json->get<std::string>();
  problem(item, fmt::format("expected {}, a string{}", what,
                            item.json ? ", found " + std::string(item.json->type_name()) : ""));
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

}  // namespace continua
