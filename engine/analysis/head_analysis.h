// The exact half of the analysis: of a machine whose heads (state, registers, topmost symbol) are finitely many, each
// that inputs can lead to is looked at.
#pragma once

#include <memory>

#include "analysis/machine_analysis.h"

namespace continua {

/// Adds conflicts, unreachable states, transitions that never fire and ε-cycles to `analysis`. Returns whether it could
/// be decided; if not, nothing of `analysis` means anything. REQUIRES a machine that reads nothing from outside.
bool analyse_heads(const std::shared_ptr<const Machine>& machine, MachineAnalysis& analysis);

}  // namespace continua
