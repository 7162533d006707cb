// An explanation as text for people.
#pragma once

#include <cstddef>
#include <string>

#include "continua/core/located_json.h"

namespace continua {

struct ExplainTextOptions {
  std::size_t width = 100;  ///< columns of a line
  bool all = false;         ///< every refused transition, input and symbol, and not only the nearest
  bool colour = false;      ///< headings in bold, numbers of records dimmed (ANSI escapes)
};

/// The sentence; then the inputs, the decisions, the stack, the derivation and the course of the act; each record named
/// #n. `explained` is the result of explain().
std::string explain_text(const Json& explained, const ExplainTextOptions& options);

/// The derivation alone as a tree in box-drawing lines, each node with its type, each leaf with its origin.
std::string explain_tree(const Json& explained, const ExplainTextOptions& options);

}  // namespace continua
