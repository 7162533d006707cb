// Reads the graph of a machine file: states, gates, transitions, implied states.
#pragma once

#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/document_reader.h"
#include "continua/machine_file/machine_effects.h"
#include "continua/machine_file/machine_inputs.h"
#include "continua/machine_file/machine_operations.h"
#include "continua/machine_file/machine_states.h"
#include "continua/machine_file/machine_terms.h"

namespace continua {

class GraphReader {
 public:
  /// All must outlive the reader.
  GraphReader(const TermReader& terms, SymbolReader& symbols, StateNames& names, OperationReader& operations,
              EffectReader& effects)
      : terms_(terms), symbols_(symbols), names_(names), operations_(operations), effects_(effects) {}

  /// Every state, in the order of its index; `item` describes some of them or is absent.
  std::vector<State> states(const Item& item);
  std::vector<Transition> transitions(const Item& item);
  /// The states that moves of another avatar imply.
  std::vector<Implied> implied(const Item& item);

 private:
  std::optional<Gate> gate(const Item& item, const std::string& state);
  std::optional<Transition> transition(const Item& item);
  std::vector<StateIndex> origins(const Item& from);

  const TermReader& terms_;
  SymbolReader& symbols_;
  StateNames& names_;
  OperationReader& operations_;
  EffectReader& effects_;
};

}  // namespace continua
