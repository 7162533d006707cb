// Loads machines and their language: facts of the world, phrases, and the data for understanding speech and gestures,
// which are a lexicon, a catalogue of gestures, the raising rules, and the voxemes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/moves/understanding.h"

namespace continua {

/// The names that terms of lexicons and raising rules may use: those of the term language and of the facts of the
/// world.
Signature names_of_terms();

/// The raising rules of this data; none without a file of them.
Result<RaisingRules> load_raising(const DataPaths& data);

/// Loads a machine with the phrases of this data, in `language` instead of its own unless that is empty. `path` and
/// errors as in machine_file/machine_loader.h; `where`: the error's place if there is no such language.
Result<Machine> load_machine(const std::string& path, const DataPaths& data, const std::string& language = "",
                             const std::string& where = "");

/// Loads the language of a machine. Lexicon and gestures are null if the machine names none; voxemes are empty without
/// a folder of them. The error is the first problem of a file, or a missing lexicon or file of gestures.
Result<Language> load_language(const DataPaths& data, const Machine& machine);

/// The digests of all files that load_language() reads for this machine, for the header of a run:
/// {"lexicon/NAME/FILE": digest of its bytes, …}, and likewise gestures, raising rules and voxemes. `language`: what
/// load_language() gave. Files that cannot be read are left out.
Json knowledge_digests(const DataPaths& data, const Machine& machine, const Language& language);

/// A lexicon by its name in knowledge/lexicon, or by its path. `where`: the error's place.
Result<std::shared_ptr<const Lexicon>> load_named_lexicon(const DataPaths& data, const std::string& name,
                                                          const std::string& where);

/// Gestures by their name in knowledge/gestures, or by a path. Their meanings are terms over the words of `lexicon`
/// (null: over the term language and facts of the world). `where`: the error's place.
Result<std::shared_ptr<const GestureCatalogue>> load_gestures(const DataPaths& data, const std::string& name,
                                                              const std::shared_ptr<const Lexicon>& lexicon,
                                                              const std::string& where);

/// An error for each meaning that is not a term over the lexicon's words.
std::vector<Error> check_meanings(const GestureCatalogue& gestures, const std::shared_ptr<const Lexicon>& lexicon);

}  // namespace continua
