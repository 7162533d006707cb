// Reads the belief table of a machine file (FORMAT.md, Beliefs).
#pragma once

#include <string>
#include <vector>

#include "continua/automaton/beliefs.h"
#include "continua/core/document_reader.h"
#include "continua/machine_file/machine_inputs.h"
#include "continua/machine_file/machine_terms.h"

namespace continua {

/// The table; an empty one if the item is absent.
BeliefTable read_beliefs(const Item& item, const TermReader& terms, SymbolReader& symbols);

}  // namespace continua
