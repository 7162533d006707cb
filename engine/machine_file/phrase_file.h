// What the avatar says, as a file that people can reword (automaton/FORMAT.md, Phrases):
//
//   { "phrases": 1,
//     "say": { "ask_thing": [ { "when": "pending = 'put'", "say": ["What should I put there?", "Put what there?"] },
//                             { "say": "What do you mean?" } ] } }
//
// Here its shape is checked; its terms are read with those of a machine that uses them (machine_file/machine_loader.h).
#pragma once

#include <string>
#include <vector>

#include "core/located_json.h"

namespace continua {

/// NAME.json of `folder`. An error without a place: there is no such file; else it is what is wrong with the JSON.
Result<LocatedJson> read_phrases(const std::string& name, const std::string& folder);

/// What is wrong with the shape of a phrase file, in the order of the file: "file:line:column: found …, expected …".
std::vector<Error> phrase_problems(const LocatedJson& document);

}  // namespace continua
