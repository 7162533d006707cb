// How a term of a run came about: applications of continuations, from the leaves up.
#pragma once

#include <string>

#include "continua/replay/explain/explain_scope.h"

namespace continua {

/// The term that the scope's record is about (an act's program, what the turn composed last, what is on the stack) as a
/// tree, or null where there is none. A node is {"term", "type": text or null, and
///  "how": `application` (then "n", "rule" and two "children": function, argument),
///         `abstraction` (a lambda over its one child: what it lacks was left open),
///         `parts` (no application is in the log: the machine put the children together; "origin" tells since when it
///         had the whole, and is left out where nothing tells),
///         `taught` (one step of what the child was taught to mean) or
///         `leaf` (then "origin", see origin_of; of a choice with "settled_by", the input since which it is this one)}.
Json derivation_of(ExplainScope& scope);

/// The same of this term as the scope's record has it. REQUIRES not empty.
Json derivation_of(ExplainScope& scope, const std::string& term);

}  // namespace continua
