// Loads the machine that a command's argument names.
#pragma once

#include <memory>
#include <string>

#include "continua/automaton/machine.h"
#include "continua/core/result.h"

namespace continua {

/// `name`: a name in the knowledge folder, or the path of a machine file or JFLAP file. `knowledge`: a folder; empty:
/// the program's own.
Result<std::shared_ptr<const Machine>> load_named_machine(const std::string& name, const std::string& knowledge = "");

}  // namespace continua
