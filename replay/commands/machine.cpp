#include "continua/replay/commands/machine.h"

#include <algorithm>
#include <iterator>
#include <memory>
#include <set>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "continua/analysis/acceptance.h"
#include "continua/analysis/machine_analysis.h"
#include "continua/core/characters.h"
#include "continua/core/replaced_file.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/knowledge_files/language_loading.h"
#include "continua/knowledge_files/named_machine.h"
#include "continua/machine_file/jflap_writer.h"
#include "continua/replay/export/graph_dot.h"
#include "continua/replay/export/graph_part.h"
#include "continua/replay/log/record_json.h"
#include "continua/replay/recogniser/speech_grammar.h"
#include "continua/replay/recorder/machine_graph.h"
#include "continua/replay/session/live_setup.h"
#include "continua/simulation/scene.h"

namespace continua {
namespace {

using Names = std::vector<std::string>;

constexpr std::size_t words_shown = 20;

std::string list(const Names& names) { return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")); }

Names inputs_of(const Machine& machine) {
  std::set<std::string> inputs;
  for (const auto& transition : machine.transitions) {
    if (!transition.on) continue;
    inputs.insert(transition.on->names.begin(), transition.on->names.end());
    for (const auto& prefix : transition.on->prefixes) inputs.insert(prefix + "*");
  }
  return {inputs.begin(), inputs.end()};
}

Names accepting_of(const Machine& machine) {
  Names names;
  for (const auto& state : machine.states)
    if (state.accepting) names.push_back(state.name);
  return names;
}

Names slots_of(const Machine& machine) {
  Names slots;
  for (const auto& slot : machine.slots)
    slots.push_back(fmt::format("{}: {}{}", slot.name, slot.type.text(), slot.persists ? ", persists" : ""));
  return slots;
}

std::string conflict_line(const Machine& machine, const Conflict& conflict, bool decided) {
  auto line = fmt::format("  in {}, {}: {} and {}", machine.states[conflict.state].name,
                          conflict.input ? "input " + *conflict.input : "without input",
                          machine.transitions[conflict.first].id, machine.transitions[conflict.second].id);
  if (!conflict.witness.empty()) line += fmt::format("; {} {}", decided ? "with" : "if", conflict.witness);
  if (conflict.word) line += conflict.word->empty() ? "; at the start" : "; after " + *conflict.word;
  return line + "\n";
}

std::string examples_line(const std::shared_ptr<const Machine>& machine) {
  int words = 0, runs = 0;
  Names failed;
  for (const auto& example : machine->examples) {
    const auto* word = std::get_if<WordExample>(&example);
    if (!word) {
      ++runs;
      continue;
    }
    ++words;
    Acceptance acceptance(machine, word->by_empty_stack ? AcceptBy::empty_stack : AcceptBy::final_state);
    const auto verdict = acceptance.accepts(word->word);
    if (!verdict || *verdict != word->accepted) failed.push_back(fmt::format("'{}'", fmt::join(word->word, " ")));
  }
  auto line = fmt::format("examples: {}, {}", counted(static_cast<std::size_t>(words), "word"),
                          counted(static_cast<std::size_t>(runs), "run"));
  if (words > 0) line += failed.empty() ? "; the words hold" : "; NOT as they say: " + list(failed);
  return line + "\n";
}

// Class, size, conflicts with their witnesses, unreachable states, dead ends, transitions that never fire, ε-cycles
// that change nothing, and whether the words of its examples are accepted as they say. Several lines.
std::string description_of(const std::shared_ptr<const Machine>& machine) {
  const auto analysis = analyse(machine);
  const auto state_names = [&](const std::vector<StateIndex>& states) {
    Names names;
    for (const auto state : states) names.push_back(machine->states[state].name);
    return names;
  };
  const auto ids = [&](const std::vector<std::size_t>& transitions) {
    Names names;
    for (const auto transition : transitions) names.push_back(machine->transitions[transition].id);
    return names;
  };
  const auto silent = static_cast<std::size_t>(
      std::count_if(machine->transitions.begin(), machine->transitions.end(), [](const auto& t) { return !t.on; }));

  auto text = fmt::format("{}: {}\n", machine->name, analysis.class_name());
  if (analysis.decided)
    text += "decided: every configuration that inputs can lead to has been considered\n";
  else
    text += fmt::format("judged by its graph and the text of its conditions, since {}\n", analysis.undecided);
  text += fmt::format("{}, start {}, accepting {}\n", counted(machine->states.size(), "state"),
                      machine->states[machine->start].name, list(accepting_of(*machine)));
  text += fmt::format("{}, {} of them ε{}; policy {}\n", counted(machine->transitions.size(), "transition"), silent,
                      analysis.weighted ? ", weighted" : "", name_of(machine->choice));
  text += fmt::format("inputs: {}\n", list(inputs_of(*machine)));
  text += fmt::format("slots: {}\n", list(slots_of(*machine)));
  text += fmt::format("{}: {}\n", analysis.decided ? "conflicts" : "possible conflicts", analysis.conflicts.size());
  for (const auto& conflict : analysis.conflicts) text += conflict_line(*machine, conflict, analysis.decided);
  text += fmt::format("unreachable states: {}\n", list(state_names(analysis.unreachable)));
  text += fmt::format("dead ends: {}\n", list(state_names(analysis.dead_ends)));
  text += fmt::format("transitions that can never fire: {}\n", list(ids(analysis.never_fires)));
  for (const auto& cycle : analysis.epsilon_cycles)
    text += fmt::format("ε-cycle that changes nothing: {}\n", list(ids(cycle)));
  return text + examples_line(machine);
}

// The words that begin the lines of a pronouncing dictionary; "the(2)" is another pronunciation.
Result<std::set<std::string, std::less<>>> pronounced_words(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return text.error();
  std::set<std::string, std::less<>> words;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);)
    if (auto word = line.substr(0, line.find_first_of(" \t(\r")); !word.empty()) words.insert(folded(word));
  if (words.empty()) return Error{path, "has no words; expected a word and its sounds on each line"};
  return words;
}

// The sentence about words of the grammar that cannot be pronounced.
void tell_unpronounced(const MachineOptions& options, const std::set<std::string>& words) {
  if (words.empty()) return;
  const std::vector<std::string> some(
      words.begin(), std::next(words.begin(), static_cast<std::ptrdiff_t>(std::min(words.size(), words_shown))));
  report_warning(
      {options.dictionary, fmt::format("lacks {}, which the grammar leaves out: {}{}", counted(words.size(), "word"),
                                       fmt::join(some, ", "), some.size() < words.size() ? ", …" : "")});
}

Result<std::string> jsgf_of(const MachineOptions& options, const Machine& machine) {
  const auto data = find_data_paths(options.knowledge);
  if (!data) return data.error();
  const auto language = load_language(*data, machine);
  if (!language) return language.error();
  if (!language->lexicon) return Error{options.machine, "has no lexicon; expected a machine that hears words"};
  auto scene_name = options.scene;
  if (scene_name.empty()) {
    const auto setup = live_setup(*data);
    if (!setup) return setup.error();
    scene_name = setup->value("scene", "");
  }
  const auto path = resolve_scene(scene_name, *data, ".", "--scene");
  if (!path) return path.error();
  const auto scene = load_scene(*path);
  if (!scene) return scene.error();
  SpeechGrammarOptions grammar_options{machine.name, options.patterns, {}, {}};
  grammar_options.is_taken = [&machine](const std::string& move) {
    return std::any_of(machine.transitions.begin(), machine.transitions.end(),
                       [&](const Transition& one) { return one.on && one.on->contains("speech " + move); });
  };
  std::set<std::string, std::less<>> known;
  if (!options.dictionary.empty()) {
    auto words = pronounced_words(options.dictionary);
    if (!words) return words.error();
    known = *std::move(words);
    grammar_options.is_pronounced = [&known](std::string_view word) { return known.contains(word); };
  }
  const auto grammar = speech_grammar(language->lexicon, scene->initial_snapshot(), grammar_options);
  if (!grammar) return grammar.error();
  if (grammar->patterns == 0) return Error{options.machine, "has no sentence for a grammar in this scene"};
  tell_unpronounced(options, grammar->unpronounced);
  return grammar->text;
}

// The machine, or its part, of a picture.
Result<StateGraph> wanted_graph(const MachineOptions& options, const Machine& machine) {
  if (options.visited.empty()) {
    const auto graph = state_graph_of(log::to_json(graph_of(machine)), machine.name);
    return graph ? part_with_states(*graph, options.picture.states) : graph;
  }
  const auto run = RunIndex::open(options.visited);
  if (!run) return run.error();
  const auto graph = visits_of_machine(machine.name, *run);
  return graph ? part_with_states(visited_part(*graph), options.picture.states) : graph;
}

Result<std::string> answer(const MachineOptions& options, const std::shared_ptr<const Machine>& machine) {
  if (options.jff) return jflap_of(*machine);
  if (options.jsgf) return jsgf_of(options, *machine);
  const bool is_part = !options.picture.states.empty() || !options.visited.empty() || !options.picture.width.empty();
  if (!options.dot && !options.svg) {
    if (is_part) return Error{options.machine, "has no picture to be cut down; expected --svg or --dot"};
    return printable(description_of(machine));
  }
  const auto graph = wanted_graph(options, *machine);
  if (!graph) return graph.error();
  return options.dot ? dot_of(*graph) : picture_of(*graph, options.picture);
}

}  // namespace

int run_machine(const MachineOptions& options) {
  const auto machine = load_named_machine(options.machine, options.knowledge);
  if (!machine) return report(machine.error()), exit_impossible;
  const auto text = answer(options, *machine);
  if (!text) return report(text.error()), exit_impossible;
  if (const auto problem = not_an_input({options.output}, {options.machine})) return report(*problem), exit_impossible;
  if (const auto problem = write_file(options.output, *text)) return report(*problem), exit_impossible;
  return exit_done;
}

void describe_machine(CLI::App& command, MachineOptions& options) {
  command.add_option("MACHINE", options.machine, "a name of the knowledge folder, or a path")->required();
  auto* dot = command.add_flag("--dot", options.dot, "its state graph for Graphviz");
  auto* svg = command.add_flag("--svg", options.svg, "its state graph as a picture, for a page")->excludes(dot);
  add_graph_options(command, options.picture);
  command.add_option("--visited", options.visited,
                     "of a picture, the states and arrows alone that this run visited, thick where it did so often");
  command.add_flag("--jff", options.jff, "a JFLAP file, if it is a finite or pushdown machine of characters")
      ->excludes(dot)
      ->excludes(svg);
  auto* jsgf =
      command
          .add_flag("--jsgf", options.jsgf,
                    "the grammar, in JSGF, of sentences that it understands in a scene, for a recogniser of speech")
          ->excludes(dot)
          ->excludes(svg);
  command.add_option("--scene", options.scene, "whose words the grammar has; otherwise that of live.json")->needs(jsgf);
  command
      .add_option("--dictionary", options.dictionary,
                  "the recogniser's pronouncing dictionary; words that it lacks are left out of the grammar")
      ->needs(jsgf);
  command
      .add_option("--patterns", options.patterns,
                  "the most kinds of sentences in the grammar: those that most examples of the lexicon have")
      ->needs(jsgf)
      ->check(CLI::Range(1, 100000))
      ->capture_default_str();
  command.add_option("--knowledge", options.knowledge, "folder to use instead of engine/knowledge");
  command.add_option("-o,--output", options.output, "a file, or '-'");
  command.footer(
      "Examples: continua machine diana2018 --svg -o diana2018.svg\n"
      "          continua machine diana2018 --svg --visited talk.run.jsonl --width 85 -o column.svg\n"
      "          continua machine interaction --jsgf --scene workbench --dictionary cmudict-en-us.dict -o said.jsgf");
}

}  // namespace continua
