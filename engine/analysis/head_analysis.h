// The exact half of the analysis, for machines with finitely many heads (state, registers, topmost symbol). It examines
// each head that inputs can lead to.
#pragma once

#include <memory>

#include "continua/analysis/machine_analysis.h"

namespace continua {

/// Adds conflicts, unreachable states, transitions that never fire and ε-cycles to `analysis`. Returns whether they
/// could be decided; if not, `analysis` is meaningless. REQUIRES a machine that reads nothing from outside.
bool analyse_heads(const std::shared_ptr<const Machine>& machine, MachineAnalysis& analysis);

}  // namespace continua
