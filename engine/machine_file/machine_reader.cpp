#include "continua/machine_file/machine_reader.h"

#include <fmt/format.h>

#include "continua/machine_file/machine_beliefs.h"
#include "continua/machine_file/machine_declarations.h"
#include "continua/machine_file/machine_effects.h"
#include "continua/machine_file/machine_examples.h"
#include "continua/machine_file/machine_graph.h"
#include "continua/machine_file/machine_inputs.h"
#include "continua/machine_file/machine_keys.h"
#include "continua/machine_file/machine_operations.h"
#include "continua/machine_file/machine_parameters.h"
#include "continua/machine_file/machine_phrases.h"
#include "continua/machine_file/machine_states.h"
#include "continua/machine_file/machine_sureness.h"
#include "continua/machine_file/machine_terms.h"

namespace continua {
namespace {

constexpr double longest_wait_s = 60;

std::optional<FusionTimes> read_fusion(const Item& item) {
  if (!item.exists() || !expect_kind(item, "fusion")) return std::nullopt;
  FusionTimes times;
  for (auto [key, time_s] : {std::pair("before", &times.before_s),
                             {"after", &times.after_s},
                             {"lateness", &times.lateness_s},
                             {"pause", &times.pause_s},
                             {"together", &times.together_s}})
    *time_s = item.member(key).number("seconds", *time_s, 0, longest_wait_s);
  return times;
}

ContextTerms read_context(const Item& item, bool has_lexicon, const TermReader& terms) {
  if (!item.exists() || !expect_kind(item, "a context")) return {};
  if (!has_lexicon) item.problem_at_key("nothing is understood without a lexicon; expected \"lexicon\"");
  const auto objects = Type::list(Type::entity());
  const auto nouns = Type::list(Type::function(Type::entity(), Type::truth()));
  const auto places = Type::list(Type::location());
  return {.focus = terms.term(item.member("focus"), objects),
          .among = terms.term(item.member("among"), objects),
          .topic = terms.term(item.member("topic"), nouns),
          .handled = terms.term(item.member("handled"), objects),
          .shown_things = terms.term(item.member("shown_things"), places),
          .shown_places = terms.term(item.member("shown_places"), places)};
}

class MachineReader {
 public:
  MachineReader(const LocatedJson& document, const Signature& facts, const std::string& phrases,
                const std::string& language, const RaisingRules& raising)
      : language_(language),
        root_(reader_.root(document)),
        terms_(facts, &raising),
        states_(root_),
        operations_(machine_, terms_, states_),
        phrases_(reader_, terms_, phrases),
        effects_(machine_, terms_, operations_, phrases_),
        graph_(terms_, symbols_, states_, operations_, effects_) {}

  ReadMachine read() {
    if (expect_kind(root_, "a machine")) {
      machine_.document = compact(root_.json());
      read_declarations();
      read_header();
      read_perception();
      read_dialogue();
      check_memory(root_.member("memory"), machine_);
      symbols_.report_misspelt();
      symbols_.report_unmatched_keys();
      check_sureness(machine_, root_);
      states_.report_misspelt();
    }
    auto problems = reader_.problems();
    problems.insert(problems.end(), phrases_.file_problems().begin(), phrases_.file_problems().end());
    if (problems.empty()) machine_.index();
    return {std::move(machine_), std::move(problems)};
  }

 private:
  // Reads the declarations, in the order in which terms may use them.
  void read_declarations() {
    if (const auto lexicon = root_.member("lexicon"); lexicon.exists()) {
      machine_.lexicon = lexicon.name("the name of a lexicon");
      if (!language_.empty()) machine_.lexicon = language_;
      terms_.add_understood();
    }
    machine_.programs = read_programs(root_.member("programs"), terms_);
    machine_.parameters = read_parameters(root_.member("parameters"), terms_);
    for (const auto& parameter : machine_.parameters) machine_.definitions.emplace(parameter.name, parameter.value);
    machine_.slots = read_slots(root_.member("slots"), terms_);
    for (std::size_t i = 0; i < machine_.slots.size(); ++i) machine_.slot_index.emplace(machine_.slots[i].name, i);
    machine_.bottom = read_bottom(root_.member("bottom"), machine_);
    machine_.memory = read_memory(root_.member("memory"), terms_);
    for (std::size_t i = 0; i < machine_.memory.size(); ++i)
      machine_.register_index.emplace(machine_.memory[i].name, i);
    symbols_.read_sets(root_.member("inputs"));
    auto definitions = terms_.definitions(root_.member("define"));
    machine_.definitions.merge(definitions.terms);
    machine_.tables = std::move(definitions.tables);
  }

  void read_header() {
    root_.expect_version("machine", 1);
    root_.member("$schema").text("where the schema is");
    machine_.name = root_.required("name", "the machine's name").name("the machine's name");
    machine_.start = states_.named(root_.required("start", "the state in which a run begins")).value_or(0);
    for (const auto& state : root_.member("accept").elements("the accepting states"))
      if (const auto index = states_.named(state)) accepting_.push_back(*index);
    if (const auto choice = root_.member("choice"); choice.exists()) {
      const auto policy = parse_choice(choice.text("a policy"));
      if (policy) machine_.choice = *policy;
      if (!policy && choice.is_text()) choice.mismatch(choice_names());
    }
    if (const auto epsilon = root_.member("epsilon").one_of({"always", "after_rewrite"}))
      machine_.epsilon_always = *epsilon == "always";
    machine_.rewrite_below = root_.member("rewrite_below").truth(false);
    machine_.repeats_utterances = root_.member("repeat_utterances").truth(true);
    machine_.minimum_confidence = root_.member("minimum_confidence").number("a confidence", 0, 0, 1);
    machine_.perspective = root_.member("perspective").one_of({"human", "avatar"}).value_or("");
  }

  void read_moves(const Item& moves) {
    if (!moves.is_list()) {
      for (const auto& [name, inputs] : moves.members("moves and their inputs"))
        machine_.moves.push_back({name, symbols_.symbols(inputs)});
      return;
    }
    for (const auto& item : moves.elements("moves")) {
      if (!expect_kind(item, "a move")) continue;
      auto name = item.required("move", "the name of a move").name("the name of a move");
      machine_.moves.push_back({std::move(name), symbols_.symbols(item.required("inputs", "the inputs of the move"))});
    }
  }

  void read_perception() {
    machine_.gestures = root_.member("gestures").name("the name of a gesture catalogue");
    machine_.fusion = read_fusion(root_.member("fusion"));
    machine_.context = read_context(root_.member("context"), !machine_.lexicon.empty(), terms_);
    read_moves(root_.member("moves"));
    if (const auto ignored = root_.member("ignore"); ignored.exists()) machine_.ignored = symbols_.symbols(ignored);
    symbols_.add_known({"gaze", "interim"});
    machine_.confidence = read_confidence(root_.member("confidence"), symbols_);
    machine_.near_tie = root_.member("near_tie").number("a difference of confidences", 0, 0, 1);
    machine_.gaze = read_gaze(root_.member("gaze"));
    machine_.beliefs = read_beliefs(root_.member("beliefs"), terms_, symbols_);
  }

  void read_dialogue() {
    const auto phrases = root_.member("phrases");
    machine_.phrases = phrases.is_text() ? phrases.json().get<std::string>() : "";
    if (!machine_.phrases.empty() && !language_.empty()) machine_.phrases = language_;
    machine_.phrase_document = phrases_.open(phrases, machine_.phrases, machine_.name);
    machine_.wordings = terms_.wordings(root_.member("wordings"));
    auto spoken = phrases_.take_terms();
    machine_.definitions.merge(spoken.definitions.terms);
    machine_.tables.merge(spoken.definitions.tables);
    machine_.wordings.insert(machine_.wordings.end(), spoken.wordings.begin(), spoken.wordings.end());
    machine_.states = graph_.states(root_.member("states"));
    for (const auto state : accepting_) machine_.states[state].accepting = true;
    machine_.transitions = graph_.transitions(root_.required("transitions", "a list of transitions"));
    machine_.implied = graph_.implied(root_.member("implied"));
    machine_.examples = read_examples(root_.member("examples"), machine_, symbols_, states_);
  }

  const std::string& language_;
  DocumentReader reader_;
  Item root_;
  Machine machine_;
  TermReader terms_;
  SymbolReader symbols_;
  StateNames states_;
  OperationReader operations_;
  PhraseReader phrases_;
  EffectReader effects_;
  GraphReader graph_;
  std::vector<StateIndex> accepting_;
};

}  // namespace

ReadMachine read_machine(const LocatedJson& document, const Signature& facts, const std::string& phrases,
                         const std::string& language, const RaisingRules& raising) {
  return MachineReader(document, facts, phrases, language, raising).read();
}

}  // namespace continua
