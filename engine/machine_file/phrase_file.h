// Reads files of the avatar's utterances, which people can reword (automaton/FORMAT.md, Phrases):
//
//   { "phrases": 1,
//     "define": { "many": "n > 1" },
//     "wordings": [ { "of": "\\x. grasp(x)", "say": "take {x}" } ],
//     "say": { "ask_thing": [ { "when": "pending = 'put'", "say": ["What should I put there?", "Put what there?"] },
//                             { "say": "What do you mean?" } ] } }
//
// The shape of the file is checked here. Its terms are read with the terms of a machine that uses them
// (machine_file/machine_phrases.h).
#pragma once

#include <string>
#include <vector>

#include "continua/core/located_json.h"

namespace continua {

/// Reads NAME.json of `folder`. An error without a place: there is no such file. Other errors: the file is not a JSON
/// document.
Result<LocatedJson> read_phrases(const std::string& name, const std::string& folder);

/// All problems of the shape of a phrase file, in the order of the file: "file:line:column: found …, expected …".
std::vector<Error> phrase_problems(const LocatedJson& document);

}  // namespace continua
