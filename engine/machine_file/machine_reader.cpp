// A machine file from top to bottom: its header and what it declares.
#include "machine_file/machine_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "term/evaluate.h"

namespace continua {
namespace {

// Names of the moment that every term may read; FORMAT.md documents them.
Signature moment_names() {
  Signature names = {
      {"input", Type::text_type()},
      {"confidence", Type::number()},
      {"now", Type::number()},
      {"in_state", Type::text_type()},
      {"is_input", Type::function(Type::text_type(), Type::truth())},
      {"certainty", Type::function(Type::text_type(), Type::number())},
      {"wording", Type::function(Type::term(), Type::text_type())},
  };
  for (const auto& carried : carried_terms())
    if (!carried.understood) names.emplace(carried.name, *Type::parse(carried.type));
  return names;
}

const Signature& moment_signature() {
  static const Signature names = moment_names();
  return names;
}

}  // namespace

MachineReader::MachineReader(const LocatedJson& document, const Signature& methods, const std::string& phrases)
    : document_(&document), machine_document_(document), methods_(methods), phrase_folder_(phrases) {
  scope_ = term_signature();
  for (const auto* names : {&methods_, &moment_signature()}) scope_.insert(names->begin(), names->end());
}

Machine MachineReader::read() {
  const Item root{&document_->root(), ""};
  if (!expect_object(root, "a machine")) return machine_;
  machine_.document = compact(document_->root());
  for (const auto& [place, key] : document_->duplicates())
    note(place, fmt::format("the key {} a second time in this object", in_quotes(key)));
  read_lexicon(member(root, "lexicon"));
  read_programs(member(root, "programs"));
  read_parameters(member(root, "parameters"));
  read_slots(member(root, "slots"));
  read_bottom(member(root, "bottom"));
  read_memory(member(root, "memory"));
  read_inputs(member(root, "inputs"));
  read_state_names(root);
  read_definitions(member(root, "define"));
  read_header(root);
  read_phrase_file(member(root, "phrases"));
  read_fusion(member(root, "fusion"));
  read_context(member(root, "context"));
  read_moves(member(root, "moves"));
  if (const auto ignored = member(root, "ignore"); ignored.json) machine_.ignored = read_symbols(ignored);
  read_beliefs(member(root, "beliefs"));
  read_wordings(member(root, "wordings"));
  read_states(member(root, "states"));
  read_transitions(required(root, "transitions", "a list of transitions"));
  read_implied(member(root, "implied"));
  read_examples(member(root, "examples"));
  find_misspelt_sets();
  find_misspelt_states();
  if (problems_.empty() && phrase_problems_.empty()) machine_.index();
  return machine_;
}

void MachineReader::read_header(const Item& root) {
  const auto version = required(root, "machine", "1, the version of the format");
  if (version.json && *version.json != 1) mismatch(version, "1, the version of the format");
  if (const auto schema = member(root, "$schema"); schema.json) text_of(schema, "where the schema is");
  machine_.name = name_of(required(root, "name", "the machine's name"), "the machine's name");
  machine_.start = state_named(required(root, "start", "the state in which a run begins"));
  if (const auto accept = member(root, "accept"); expect_array(accept, "the accepting states"))
    for (std::size_t i = 0; i < accept.json->size(); ++i)
      machine_.states[state_named(element(accept, i))].accepting = true;
  if (const auto choice = member(root, "choice"); choice.json) {
    if (const auto policy = parse_choice(text_of(choice, "a policy")))
      machine_.choice = *policy;
    else if (choice.json->is_string())
      mismatch(choice, choice_names());
  }
  if (const auto epsilon = one_of(root, "epsilon", {"always", "after_rewrite"}))
    machine_.epsilon_always = *epsilon == "always";
  machine_.rewrite_below = truth_of(member(root, "rewrite_below"), false);
  machine_.repeats_utterances = truth_of(member(root, "repeat_utterances"), true);
  machine_.minimum_confidence = number_of(member(root, "minimum_confidence"), "a confidence", 0, 0, 1);
  if (const auto gestures = member(root, "gestures"); gestures.json)
    machine_.gestures = name_of(gestures, "the name of a gesture catalogue");
  machine_.perspective = one_of(root, "perspective", {"human", "avatar"}).value_or("");
}

// What is understood can be read by the terms of machines that understand.
void MachineReader::read_lexicon(const Item& lexicon) {
  if (!lexicon.json) return;
  machine_.lexicon = name_of(lexicon, "the name of a lexicon");
  for (const auto& carried : carried_terms())
    if (carried.understood) scope_.emplace(carried.name, *Type::parse(carried.type));
}

void MachineReader::read_fusion(const Item& fusion) {
  if (!expect_object(fusion, "fusion")) return;
  constexpr double longest_s = 60;
  FusionTimes times;
  const auto read = [&](const char* key, double& time_s) {
    time_s = number_of(member(fusion, key), "seconds", time_s, 0, longest_s);
  };
  read("before", times.before_s);
  read("after", times.after_s);
  read("lateness", times.lateness_s);
  machine_.fusion = times;
}

void MachineReader::read_context(const Item& context) {
  if (!expect_object(context, "a context")) return;
  const auto read = [&](const char* key, const Type& type, std::optional<Term>& term) {
    if (const auto item = member(context, key); item.json) term = parse(item, type);
  };
  read("focus", Type::list(Type::entity()), machine_.context.focus);
  read("among", Type::list(Type::entity()), machine_.context.among);
  read("topic", Type::list(Type::function(Type::entity(), Type::truth())), machine_.context.topic);
  if (machine_.lexicon.empty())
    problem_at_key(context, "nothing is understood without a lexicon; expected \"lexicon\"");
}

void MachineReader::read_moves(const Item& moves) {
  if (!expect_object(moves, "moves and their inputs")) return;
  for (const auto& [name, value] : moves.json->items())
    machine_.moves.push_back({name, read_symbols(member(moves, name))});
}

Type MachineReader::read_type(const Item& item) {
  if (!item.json || !item.json->is_string()) return text_of(item, "a type"), Type::term();
  auto type = Type::parse(item.json->get<std::string>());
  if (type) return *type;
  problem_in_text(item, type.error());
  return Type::term();
}

void MachineReader::declare(const Item& at, const std::string& name, const Type& type) {
  const bool is_word = name == "null" || name == "true" || name == "false";
  if (name.empty())
    problem_at_key(at, "found '', expected a name");
  else if (is_word || !scope_.emplace(name, type).second)
    problem_at_key(at, fmt::format("the name {} is taken by {}; expected another", in_quotes(name),
                                   is_word || term_signature().contains(name) ? "the term language"
                                   : methods_.contains(name)                  ? "a fact of the world"
                                   : moment_signature().contains(name)        ? "what every term may read"
                                                                              : "an earlier declaration"));
}

void MachineReader::read_programs(const Item& programs) {
  if (!expect_object(programs, "programs")) return;
  for (const auto& [name, value] : programs.json->items()) {
    const auto item = member(programs, name);
    const auto type = read_type(item);
    machine_.programs.emplace(name, type);
    declare(item, name, type);
  }
}

void MachineReader::read_slots(const Item& slots) {
  if (!expect_object(slots, "slots")) return;
  for (const auto& [name, value] : slots.json->items()) {
    const auto item = member(slots, name);
    Slot slot{name, Type::term(), false};
    if (value.is_object()) {
      expect_object(item, "a slot");
      slot.type = read_type(required(item, "type", "the slot's type"));
      slot.persists = truth_of(member(item, "persists"), false);
    } else {
      slot.type = read_type(item);
    }
    declare(item, name, slot.type);
    machine_.slot_index.emplace(name, machine_.slots.size());
    machine_.bottom.push_back({empty_value(slot.type), {}});
    machine_.slots.push_back(std::move(slot));
  }
}

// There is no moment yet and no world: only the language's own names and the machine's programs are known.
void MachineReader::read_bottom(const Item& bottom) {
  if (!expect_object(bottom, "slots and their contents")) return;
  auto known = term_signature();
  known.insert(machine_.programs.begin(), machine_.programs.end());
  std::swap(scope_, known);
  for (const auto& content : read_contents(bottom, false)) {
    if (!content.term) continue;
    static const RuleTable rules({&term_rules()});
    Evaluation evaluation(rules, [](Name) { return nullptr; });
    machine_.bottom[content.slot].value = evaluation.value(*content.term);
    if (evaluation.exhausted)
      problem(member(bottom, machine_.slots[content.slot].name), "the evaluation of this term does not end");
  }
  std::swap(scope_, known);
}

void MachineReader::read_memory(const Item& memory) {
  if (!expect_object(memory, "memory")) return;
  for (const auto& [name, value] : memory.json->items()) {
    const auto item = member(memory, name);
    if (!expect_object(item, "a register")) continue;
    Register entry{name, read_type(required(item, "type", "the register's type")), Term::null()};
    entry.initial = empty_value(entry.type);
    if (const auto initial = member(item, "initial"); initial.json)
      if (const auto term = parse(initial, entry.type)) entry.initial = *term;
    declare(item, name, entry.type);
    machine_.register_index.emplace(name, machine_.memory.size());
    machine_.memory.push_back(std::move(entry));
  }
}

}  // namespace continua
