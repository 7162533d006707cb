// Reads a machine from a located document: notes every problem with its place, and goes on.
#pragma once

#include <initializer_list>
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
  MachineReader(const LocatedJson& document, const Signature& methods);

  Machine read();
  std::vector<Error> problems;

 private:
  // machine_reader.cpp: the document from top to bottom
  void read_header(const Item& root);
  void read_programs(const Item& programs);
  void read_slots(const Item& slots);
  void read_memory(const Item& memory);
  Type read_type(const Item& item);
  void declare(const Item& at, const std::string& name, const Type& type);

  // machine_graph.cpp: how states are connected
  void read_inputs(const Item& inputs);
  void read_state_names(const Item& root);
  void read_states(const Item& states);
  void read_transitions(const Item& transitions);
  void read_transition(const Item& transition);
  const SymbolSet& named_set(const Item& inputs, const std::string& name, std::vector<std::string>& path);
  SymbolSet read_symbols(const Item& item);
  StateIndex state_named(const Item& item);

  // machine_terms.cpp: everything that is computed
  void read_definitions(const Item& definitions);
  void read_wordings(const Item& wordings);
  std::optional<Term> parse(const Item& item, const Type& expected);
  std::optional<Term> parse_text(const Item& at, const std::string& text, const Type& expected);
  std::optional<Template> read_template(const Item& item, const std::string& binders);
  Operation read_operation(const Item& object);
  std::vector<Content> read_contents(const Item& object, bool lists);
  std::vector<Effect> read_effects(const Item& list);
  std::optional<Effect> read_effect(const Item& object);

  // machine_beliefs.cpp
  void read_beliefs(const Item& beliefs);
  std::size_t concept_named(const Item& item);

  // Walking. Each notes a problem and returns an empty item or default where the shape is wrong.
  Item member(const Item& object, const std::string& key) const;
  Item element(const Item& array, std::size_t index) const;
  bool expect_object(const Item& item, const char* what, std::initializer_list<const char*> keys = {});
  bool expect_array(const Item& item, const char* what);
  std::string text_of(const Item& item, const char* what);
  double number_of(const Item& item, const char* what, double otherwise);
  bool truth_of(const Item& item, const char* what, bool otherwise);
  void problem(const Item& at, std::string sentence);

  const LocatedJson& document_;
  const Signature& methods_;
  Signature scope_;  ///< every name a term may use
  std::map<std::string, SymbolSet, std::less<>> sets_;
  std::map<std::string, StateIndex, std::less<>> state_index_;
  Machine machine_;
};

}  // namespace continua
