// Reads machine files (automaton/FORMAT.md) and checks all of them at load: names, types, shapes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "automaton/machine.h"
#include "core/result.h"

namespace continua {

/// `methods` are the names a machine's terms may use beside the term language: facts of the world.
/// JFLAP files are read too (machine_file/jflap.h). The error is the first problem of the file: "file:line:column: what
/// was found, what was expected".
/// `phrases`: the folder of phrase files; REQUIRED by machines that name one.
Result<Machine> load_machine(const std::string& path, const Signature& methods, const std::string& phrases = "");

/// The same from text; `name` stands for the file in errors.
Result<Machine> parse_machine(std::string_view text, const std::string& name, const Signature& methods,
                              const std::string& phrases = "");

/// Every problem of the text, in the order of the text, of very many the first 1000 found; empty if it is a sound
/// machine. Those of its phrases follow, with the phrase file's name and lines.
std::vector<Error> check_machine(std::string_view text, const std::string& name, const Signature& methods,
                                 const std::string& phrases = "");

}  // namespace continua
