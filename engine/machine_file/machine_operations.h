// Reads the operations on the stack of a machine file.
#pragma once

#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/document_reader.h"
#include "continua/machine_file/machine_states.h"
#include "continua/machine_file/machine_terms.h"

namespace continua {

/// Slots and the terms that fill them; with `lists`, each term is a list of values for its slot.
std::vector<Content> read_contents(const Item& item, bool lists, const Machine& declared, const TermReader& terms);

class OperationReader {
 public:
  /// `declared` has the slots. All must outlive the reader.
  OperationReader(const Machine& declared, const TermReader& terms, StateNames& states)
      : declared_(declared), terms_(terms), states_(states) {}

  /// The operation among the members of an object; `none` if there is none.
  Operation operation(const Item& object);

 private:
  std::vector<Content> cleared_slots(const Item& item) const;

  const Machine& declared_;
  const TermReader& terms_;
  StateNames& states_;
};

}  // namespace continua
