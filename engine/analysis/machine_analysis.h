// The class of a machine (SEMANTICS.md §1, Special cases) and its faults: conflicts, and states and transitions that
// can never play a part.
//
// A machine that reads only its input symbols, stack and registers, with finitely many values, is decided: saturation
// (analysis/saturation.h) finds all heads (state, registers, topmost symbol) that some word reaches. Machines that read
// the world or the content of inputs are judged by their graph and the terms of their conditions. Their conflicts are
// possible ones; their unreachable states are certain.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "continua/automaton/machine.h"

namespace continua {

/// Two transitions of one rank that apply in one configuration.
struct Conflict {
  StateIndex state = 0;
  std::size_t first = 0, second = 0;  ///< transitions, in file order
  std::optional<std::string>
      input;            ///< symbol that both take, or that one takes while the other is an ε-transition; none: both ε
  std::string witness;  ///< topmost symbol and registers, or the condition for the conflict; "": any
  std::optional<std::string> word;  ///< input symbols that lead there, joined by spaces, if found
};

struct MachineAnalysis {
  bool decided = false;             ///< false: judged by graph and text
  std::string undecided;            ///< the reason if not decided
  bool uses_stack = false;          ///< some operation changes it
  bool deterministic = true;        ///< no conflicts, and no weight but 1
  std::vector<Conflict> conflicts;  ///< one for each pair and state
  std::vector<StateIndex> unreachable;
  std::vector<StateIndex> dead_ends;     ///< reachable states that lead to no accepting (if none accepts: other) state
  std::vector<std::size_t> never_fires;  ///< transitions
  std::vector<std::vector<std::size_t>> epsilon_cycles;  ///< transitions that come back to where they began; if decided
  bool weighted = false;                                 ///< some weight is not 1

  /// "DFA", "NFA", "DPDA" or "NPDA".
  std::string class_name() const;
};

MachineAnalysis analyse(const std::shared_ptr<const Machine>& machine);

}  // namespace continua
