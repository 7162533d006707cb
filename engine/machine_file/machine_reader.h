// Reads a machine from a located document: notes every problem with its place, and goes on.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "automaton/machine.h"
#include "core/located_json.h"

namespace continua {

/// A value of the document and where it stands.
struct Item {
  const Json* json = nullptr;
  std::string pointer;
};

class MachineReader {
 public:
  /// `phrases` is the folder of phrase files. All must outlive the reader.
  MachineReader(const LocatedJson& document, const Signature& methods, const std::string& phrases);

  Machine read();
  /// All that is wrong, in the order of the document; of very many the first that were found.
  std::vector<Error> problems();

 private:
  // machine_reader.cpp: the document from top to bottom
  void read_header(const Item& root);
  void read_programs(const Item& programs);
  void read_parameters(const Item& parameters);  // machine_parameters.cpp
  void read_slots(const Item& slots);
  void read_memory(const Item& memory);
  void read_bottom(const Item& bottom);
  void read_lexicon(const Item& lexicon);
  void read_phrase_file(const Item& phrases);
  void read_fusion(const Item& fusion);
  void read_context(const Item& context);
  void read_moves(const Item& moves);
  Type read_type(const Item& item);
  void declare(const Item& at, const std::string& name, const Type& type);
  StateIndex add_state(const std::string& name);

  // machine_graph.cpp: how states are connected
  void read_state_names(const Item& root);
  void read_states(const Item& states);
  void read_transitions(const Item& transitions);
  void read_transition(const Item& transition);
  std::vector<StateIndex> read_origins(const Item& from);
  void read_gate(const Item& gate, StateIndex state);
  StateIndex state_named(const Item& item);

  // machine_inputs.cpp: sets of input symbols
  void read_inputs(const Item& inputs);
  const SymbolSet& named_set(const Item& inputs, const std::string& name, std::vector<std::string>& path);
  SymbolSet read_symbols(const Item& item);
  void add_symbol(SymbolSet& set, const Item& item);
  void find_misspelt_sets();
  void find_misspelt_states();

  // machine_terms.cpp: everything that is computed
  void read_definitions(const Item& definitions);
  void read_definition(const Item& definitions, const std::string& name, std::vector<std::string>& path);
  void read_table(const Item& table, const std::string& name);
  void read_wordings(const Item& wordings);
  void read_wording(const Item& wording);
  std::optional<Term> parse(const Item& item, const Type& expected);
  std::optional<Term> parse_part(const Item& item, std::size_t from, const std::string& text, const Type& expected,
                                 const std::string& binders);
  std::optional<Template> read_template(const Item& item, const std::string& binders);

  // machine_operations.cpp: what happens to the stack and beside it
  Operation read_operation(const Item& object);
  std::vector<Content> read_contents(const Item& object, bool lists);
  std::optional<std::size_t> slot_named(const Item& contents, const std::string& name);
  std::vector<Effect> read_effects(const Item& list);
  std::optional<Effect> read_effect(const Item& object);
  std::optional<Say> read_say(const Item& item);
  std::optional<Say> read_phrase(const Item& item);
  SayCase read_variants(const Item& item);
  std::optional<Learn> read_learn(const Item& lesson);
  std::optional<Forget> read_forget(const Item& lesson);
  std::optional<Lesson> read_lesson(const Item& lesson);
  Remember read_remember(const Item& registers);

  // machine_implied.cpp
  void read_implied(const Item& implied);

  // machine_examples.cpp
  void read_examples(const Item& examples);
  void read_example(const Item& example);

  // machine_beliefs.cpp
  void read_beliefs(const Item& beliefs);
  void read_concept(const Item& item, Concept& entry);
  void read_evidence(const Item& item);
  void read_answer(const Item& item);
  std::vector<std::size_t> concepts_named(const Item& list, const char* what);
  std::size_t concept_named(const Item& item);

  // machine_walk.cpp. Where a shape is wrong each notes a problem, and returns an empty item or default. An item
  // without a value is no problem: that it is missing was noted by `required`, or is no mistake.
  Item member(const Item& object, const std::string& key) const;
  Item required(const Item& object, const std::string& key, const char* what);
  Item element(const Item& array, std::size_t index) const;
  bool expect_object(const Item& item, const char* what);  ///< with the keys that machine_keys() knows for it, or any
  bool expect_array(const Item& item, const char* what);
  std::string text_of(const Item& item, const char* what);
  std::string name_of(const Item& item, const char* what);
  std::optional<std::string> one_of(const Item& object, const std::string& key, const std::vector<std::string>& names);
  double number_of(const Item& item, const char* what, double otherwise, double least, double most);
  bool truth_of(const Item& item, bool otherwise);
  bool mismatch(const Item& item, const std::string& expected);
  void problem(const Item& at, std::string sentence);
  /// Of the parser of terms or of types, which read the item's text from its byte `from` on, after `before` bytes of
  /// something else.
  void problem_in_text(const Item& at, const Error& error, std::size_t from = 0, std::size_t before = 0);
  void problem_at_key(const Item& at, std::string sentence);
  void note(TextPlace place, std::string sentence);
  bool full() const;
  std::string nearest(const std::string& name, const std::vector<std::string>& known) const;

  struct Problem {
    const LocatedJson* document;
    TextPlace place;
    std::string sentence;
  };
  std::vector<Problem> problems_;
  std::vector<Error> phrase_problems_;  ///< of the phrase file's shape

  const LocatedJson* document_;  ///< that is being read: the machine's, or that of its phrases
  const LocatedJson& machine_document_;
  std::optional<LocatedJson> phrases_;  ///< if it is sound
  std::map<std::string, std::optional<Say>, std::less<>> read_phrases_;
  const Signature& methods_;
  const std::string& phrase_folder_;
  Signature scope_;  ///< every name a term may use
  std::set<std::string, std::less<>> read_definitions_;
  std::map<std::string, SymbolSet, std::less<>> sets_;
  std::set<std::string, std::less<>> used_sets_;
  std::map<std::string, std::vector<Item>, std::less<>> symbols_;  ///< where each symbol that is no set's name stands
  std::set<std::string, std::less<>> known_symbols_;               ///< those of sets and examples
  std::map<std::string, StateIndex, std::less<>> state_index_;
  std::map<std::string, std::vector<Item>, std::less<>> mentions_;  ///< where transitions and others name a state
  Machine machine_;
};

}  // namespace continua
