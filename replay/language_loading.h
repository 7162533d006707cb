// Loads what a machine understands speech by: its lexicon, the raising rules, and the voxemes.
#pragma once

#include "automaton/machine.h"
#include "core/result.h"
#include "moves/understanding.h"
#include "replay/data_paths.h"

namespace continua {

/// What the terms of lexicons and raising rules may use: the language's names and facts of the world.
Signature names_of_terms();

/// The lexicon is null for a machine that names none; the catalogue is empty without a folder voxemes. The error is the
/// first problem of a file, or that there is no such lexicon.
Result<Language> load_language(const DataPaths& data, const Machine& machine);

/// A lexicon by its name in knowledge/lexicon, or by its path. `where` is the error's place.
Result<std::shared_ptr<const Lexicon>> load_named_lexicon(const DataPaths& data, const std::string& name,
                                                          const std::string& where);

}  // namespace continua
