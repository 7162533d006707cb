// Reads the examples of a machine file: inputs and the state they lead to, words that are accepted or not.
#pragma once

#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/document_reader.h"
#include "continua/machine_file/machine_inputs.h"
#include "continua/machine_file/machine_states.h"

namespace continua {

/// `machine` has its transitions: the symbols of an accepted word must be among their inputs.
std::vector<Example> read_examples(const Item& item, const Machine& machine, SymbolReader& symbols, StateNames& states);

}  // namespace continua
