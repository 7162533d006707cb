// Reads the declarations of a machine file: programs, slots, registers. Terms may use the declared names.
#pragma once

#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/document_reader.h"
#include "continua/machine_file/machine_terms.h"

namespace continua {

/// Programs and their types.
Signature read_programs(const Item& item, TermReader& terms);

std::vector<Slot> read_slots(const Item& item, TermReader& terms);

/// The symbol at the bottom of every stack: the item's values for some slots, empty values for the others. `declared`
/// has slots and programs.
Symbol read_bottom(const Item& item, const Machine& declared);

std::vector<Register> read_memory(const Item& item, TermReader& terms);

/// Notes a problem for each operation that is to clear a register and that the machine never performs. `machine` has
/// its transitions and states.
void check_memory(const Item& item, const Machine& machine);

}  // namespace continua
