// Runs the examples that machines and lexicons carry.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/moves/understanding.h"

namespace continua {

/// A sentence for each example of the machine that is not true of it. Inputs are events without a place, on an empty
/// table.
std::vector<std::string> broken_examples(const std::shared_ptr<const Machine>& machine,
                                         const std::shared_ptr<const Language>& language);

}  // namespace continua
