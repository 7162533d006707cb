// Terms put into words: templates with terms to fill in, and a table of how terms of a shape are called
// (FORMAT.md, Wordings).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/term/evaluate.h"

namespace continua {

/// The template with its holes filled; each hole is first applied to `arguments`. A text fills in as its characters,
/// anything else as it prints. nullopt when a hole is null: then there is nothing to say.
std::optional<std::string> fill_template(const Template& text, const std::vector<Term>& arguments,
                                         Evaluation& evaluation);

/// The words of the first wording whose pattern fits the term and whose condition holds.
std::optional<std::string> wording_of(const Term& term, const std::vector<Wording>& wordings, Evaluation& evaluation);

}  // namespace continua
