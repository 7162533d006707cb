// Weights of a machine that are kept apart from its file, such as learned ones: how likely each of rival transitions
// is, and how sure evidence makes (FORMAT.md, Weights).
//
//   { "weights": 1, "machine": "diana2018",
//     "transitions": { "guess": 0.7, "wait": 0.3 },
//     "evidence": [ { "row": 1, "concepts": ["point"], "levels": [0.04, 0.98] } ] }
#pragma once

#include <string>
#include <vector>

#include "continua/automaton/machine.h"
#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

/// The heaviest weight of a transition: sums of weights stay exact enough.
inline constexpr double heaviest_weight = 1e9;

/// The weights of a machine's transitions, and the levels of its evidence, each in the order of the machine.
struct MachineWeights {
  std::vector<double> transitions;          ///< > 0
  std::vector<std::vector<double>> levels;  ///< ascending, 0 … 1
};

/// Those of the machine as it is.
MachineWeights weights_of(const Machine& machine);

/// Those that differ from the machine's own, as a file has them.
Json weights_document(const Machine& machine, const MachineWeights& weights);

/// The machine's own weights, with those of the file in their place. Errors, with their place in the file: it is of
/// another machine, names what the machine does not have, or holds no weights.
Result<MachineWeights> read_weights(const std::string& path, const Machine& machine);

/// Puts the weights into the machine and into its document. REQUIRES weights of this machine. Error: the machine's file
/// is not the project's JSON.
Outcome set_weights(Machine& machine, const MachineWeights& weights);

}  // namespace continua
