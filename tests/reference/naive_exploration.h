// Every run of a nondeterministic machine at once, and which words it accepts: the textbook's reading, in which
// ε-transitions are taken or not at every point.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/naive_automaton.h"

namespace naive {

/// Configurations, no two of them equal.
using Configurations = std::vector<Configuration>;

/// All in which a run may be that has not yet read anything. Nothing if there are more than `most`.
std::optional<Configurations> explored(const Machine& machine, std::size_t most);

/// All that any of the inputs leads to; empty where none is taken. Nothing if there are more than `most`.
std::optional<Configurations> explored(const Machine& machine, const Configurations& before,
                                       const std::vector<Offer>& offers, std::size_t most);
inline std::optional<Configurations> explored(const Machine& machine, const Configurations& before, char input,
                                              std::size_t most) {
  return explored(machine, before, {{input, 1}}, most);
}

enum class Acceptance { final_state, empty_stack };

/// In an accepting state, or with nothing but the bottom symbol.
bool accepts(const Machine& machine, const Configuration& configuration, Acceptance by);

/// Whether a run over the whole word ends so, of however many there are. Reads no history: REQUIRES a machine without
/// pop_until.
bool accepts(const Machine& machine, const std::string& word, Acceptance by);

}  // namespace naive
