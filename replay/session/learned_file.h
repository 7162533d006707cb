// Where what was taught is kept from run to run (learning/learning_file.h).
#pragma once

#include <string>

#include "continua/automaton/machine.h"
#include "continua/core/result.h"
#include "continua/learning/learning.h"
#include "continua/moves/understanding.h"

namespace continua {

/// What the file holds; nothing if there is none. Errors: its first problem, or a word that the machine has another
/// meaning for.
Result<Learned> read_learned(const std::string& path, const Machine& machine, const Language& language);

/// The new file takes the place of the old one at once: whoever reads it sees one of them, whole.
Outcome write_learned(const std::string& path, const Learned& learned);

}  // namespace continua
