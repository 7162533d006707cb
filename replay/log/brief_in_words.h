// A record in a few words, as people name its things, places, gestures and programs.
#pragma once

#include <cstddef>
#include <string>

#include "continua/core/located_json.h"
#include "continua/replay/log/run_words.h"

namespace continua {

/// The input as a reader knows it: “Put it there.”, gesture “yes”, pointing right [0.1,0.2], act 1, “puts the cup
/// back”, missed. Of an n-best list the alternative of this number, as in RUNLOG.md.
std::string input_text(const RunWords& words, const Json& input, std::size_t alternative = 0);

/// brief() in the words of a run: asked “puts the white cup on the plate”. λ-terms, which have no such words, are as
/// brief() has them.
std::string brief_in_words(const RunWords& words, const Json& record);

}  // namespace continua
