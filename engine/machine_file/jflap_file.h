// A JFLAP file as it is written: its states and transitions, checked, not yet a machine of ours.
#pragma once

#include <compare>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"

namespace continua {

struct JflapState {
  std::string name;  ///< as in the file, "q" and its id where there is none; may occur twice
  long id = 0;
  bool accepting = false;
};

struct JflapTransition {
  std::size_t from = 0, to = 0;              ///< indices of states
  std::vector<std::string> read, pop, push;  ///< characters; none is λ
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
