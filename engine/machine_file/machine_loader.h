// Loads machine files (automaton/FORMAT.md) and checks everything in them: names, types, shapes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/result.h"
#include "continua/term/raising.h"

namespace continua {

/// The machine of a file, also of a JFLAP file (machine_file/jflap.h). `facts`: the names of facts of the world, which
/// terms may use besides the term language. `phrases`: the folder of phrase files; REQUIRED by machines that name one.
/// `raising`: the rules by which contents of slots and registers are lifted to the types of these.
/// `language`: the lexicon and the phrase file that replace those that the machine names; empty: the machine's own.
/// The error is the first problem of the file: "file:line:column: found …, expected …".
Result<Machine> load_machine(const std::string& path, const Signature& facts, const std::string& phrases = "",
                             const std::string& language = "", const RaisingRules& raising = {});

/// The machine of a JSON text; `name` stands for the file in errors.
Result<Machine> parse_machine(std::string_view text, const std::string& name, const Signature& facts,
                              const std::string& phrases = "", const std::string& language = "",
                              const RaisingRules& raising = {});

/// Every problem of a JSON text, in the order of the text; empty if the machine is sound. Of more than 1000 problems,
/// the first 1000 that were found. Problems of the phrase file follow, with its name and lines.
std::vector<Error> check_machine(std::string_view text, const std::string& name, const Signature& facts,
                                 const std::string& phrases = "", const std::string& language = "",
                                 const RaisingRules& raising = {});

}  // namespace continua
