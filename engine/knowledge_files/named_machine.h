// The machine that a command's argument means.
#pragma once

#include <memory>
#include <string>

#include "continua/automaton/machine.h"
#include "continua/core/result.h"

namespace continua {

/// `name`: of the knowledge folder, or a path to a machine file or one of JFLAP's. `knowledge`: a folder; empty: the
/// program's own.
Result<std::shared_ptr<const Machine>> load_named_machine(const std::string& name, const std::string& knowledge = "");

}  // namespace continua
