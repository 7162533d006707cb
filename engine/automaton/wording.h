// Puts terms into words: templates with terms to fill in, and a table of wordings for shapes of terms (FORMAT.md,
// Wordings).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/term/evaluate.h"

namespace continua {

/// The template with its holes filled; each hole is first applied to `arguments`. A text fills in as its characters,
/// any other value as it prints. nullopt if a hole is null: then there is nothing to say.
std::optional<std::string> fill_template(const Template& text, const std::vector<Term>& arguments,
                                         Evaluation& evaluation);

/// The words of the first wording whose pattern fits the term, whose condition holds and whose holes can be filled.
std::optional<std::string> wording_of(const Term& term, const std::vector<Wording>& wordings, Evaluation& evaluation);

}  // namespace continua
