// Reads a machine from its document, top to bottom; one reader for each part of the file (machine_terms.h,
// machine_inputs.h, machine_states.h, machine_operations.h …).
#pragma once

#include <string>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/located_json.h"
#include "continua/term/raising.h"

namespace continua {

struct ReadMachine {
  Machine machine;  ///< complete and indexed if there are no problems
  /// All problems, in the order of the document; those of the phrase file follow.
  std::vector<Error> problems;
};

/// `facts`: the names that terms may use besides the term language. `phrases`: the folder of phrase files. `language`
/// replaces the names of the machine's lexicon and phrases unless it is empty. `raising`: see load_machine().
ReadMachine read_machine(const LocatedJson& document, const Signature& facts, const std::string& phrases,
                         const std::string& language, const RaisingRules& raising);

}  // namespace continua
