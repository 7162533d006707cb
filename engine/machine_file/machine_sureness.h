// Reads how a machine deals with what recognisers are not sure of: thresholds, near ties, words that are not final.
#pragma once

#include <optional>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/machine_file/machine_inputs.h"

namespace continua {

/// The machine's `confidence`: thresholds by symbols or sets.
std::vector<Thresholds> read_confidence(const Item& item, SymbolReader& symbols);

/// The machine's `gaze`.
std::optional<GazeTimes> read_gaze(const Item& item);

/// Reports thresholds and near ties of a machine without a transition that takes `unsure`, and transitions that take
/// `interim` and do more than look: words that are not final may not lead to an act. `root`: the machine.
void check_sureness(const Machine& machine, const Item& root);

}  // namespace continua
