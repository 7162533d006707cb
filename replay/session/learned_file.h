// The file that keeps lessons from run to run (learning/learning_file.h).
#pragma once

#include <string>

#include "continua/automaton/machine.h"
#include "continua/core/result.h"
#include "continua/learning/learning.h"
#include "continua/moves/understanding.h"

namespace continua {

/// The lessons in the file; nothing if there is no file. Errors: the first problem of the file, or a word for which the
/// machine has another meaning.
Result<Learned> read_learned(const std::string& path, const Machine& machine, const Language& language);

/// The new file takes the place of the old one at once: a reader sees one of them, whole.
Outcome write_learned(const std::string& path, const Learned& learned);

}  // namespace continua
