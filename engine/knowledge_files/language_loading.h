// Loads machines with their knowledge: the facts of the world, the phrases, and the lexicon, gestures, raising rules
// and voxemes by which speech and gestures are understood.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/result.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/moves/understanding.h"

namespace continua {

/// The names that terms of lexicons and raising rules may use: the language's and facts of the world.
Signature names_of_terms();

/// A machine with this data's phrases, in `language` instead of its own unless that is empty. `path` and errors as
/// machine_file/machine_loader.h has them; `where` is the error's place if there is no such language.
Result<Machine> load_machine(const std::string& path, const DataPaths& data, const std::string& language = "",
                             const std::string& where = "");

/// Lexicon and gestures are null for a machine that names none; without a folder of voxemes there are none. The error
/// is the first problem of a file, or the absence of such a lexicon or such gestures.
Result<Language> load_language(const DataPaths& data, const Machine& machine);

/// The files that load_language reads for this machine, as a run's header has them: {"lexicon/NAME/FILE": digest of its
/// bytes, …}, the machine's gestures, the raising rules and all voxemes likewise. Files that cannot be read are left
/// out.
Json knowledge_digests(const DataPaths& data, const Machine& machine);

/// A lexicon by its name in knowledge/lexicon, or by its path. `where` is the error's place.
Result<std::shared_ptr<const Lexicon>> load_named_lexicon(const DataPaths& data, const std::string& name,
                                                          const std::string& where);

/// Gestures by their name in knowledge/gestures, or by a path, whose meanings are terms of `lexicon`'s words (null: of
/// the term language's and facts of the world). `where` is the error's place.
Result<std::shared_ptr<const GestureCatalogue>> load_gestures(const DataPaths& data, const std::string& name,
                                                              const std::shared_ptr<const Lexicon>& lexicon,
                                                              const std::string& where);

/// The meanings that are no terms of the lexicon's words.
std::vector<Error> check_meanings(const GestureCatalogue& gestures, const std::shared_ptr<const Lexicon>& lexicon);

}  // namespace continua
