// How a term of a run came about: applications of continuations, from the leaves up.
#pragma once

#include <string>

#include "continua/replay/explain/explain_scope.h"

namespace continua {

/// The term that the scope's record is about (an act's program, the turn's last composition, a term of the stack) as a
/// tree, or null where there is none. A node is {"term", "structure": the term taken apart (term_structure.h), "type":
/// text or null, and
///  "how": `application` (then "n", "rule" and two "children": function, argument),
///         `abstraction` (a lambda over its one child, with an open part),
///         `parts` (no application is in the log: the machine put the children together; "origin" says since when it
///         had the whole, and is left out where nothing says so),
///         `taught` (one step of the child's taught meaning) or
///         `leaf` (then "origin", see origin_of; of a choice with "settled_by", the input that settled it)}.
Json derivation_of(ExplainScope& scope);

/// The same of this term as the scope's record has it. REQUIRES not empty.
Json derivation_of(ExplainScope& scope, const std::string& term);

}  // namespace continua
