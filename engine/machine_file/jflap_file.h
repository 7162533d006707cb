// The contents of a JFLAP file: its states and transitions, checked, but not yet a machine (machine_file/jflap.h).
#pragma once

#include <compare>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"

namespace continua {

struct JflapState {
  std::string name;  ///< as in the file, or "q" and its id if it has none; may occur twice
  long id = 0;
  bool accepting = false;
};

struct JflapTransition {
  std::size_t from = 0, to = 0;              ///< indices of states
  std::vector<std::string> read, pop, push;  ///< characters; empty: λ
  bool reads_any = false;                    ///< reads one of `read` instead of all of them in order

  auto operator<=>(const JflapTransition&) const = default;
};

struct JflapAutomaton {
  bool pushdown = false;
  std::vector<JflapState> states;
  std::size_t start = 0;
  std::vector<JflapTransition> transitions;  ///< in file order, each once
};

/// Reads a file of type `fa` or `pda`; `name` stands for it in errors, which name the line.
Result<JflapAutomaton> read_jflap(std::string_view text, const std::string& name);

}  // namespace continua
