// The policy `explore`: the set of all configurations that a machine may be in (SEMANTICS.md §1, Nondeterminism).
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "continua/automaton/stepper.h"

namespace continua {

/// A configuration of the set, and its origin.
struct Branch {
  int id = 0;      ///< the parent's id for the first of several children, else a new one
  int parent = 0;  ///< the branch of the step before that it comes from
  Configuration configuration;
  double weight = 1;            ///< of the heaviest way to it; the weights of a set sum to 1
  bool settled = true;          ///< no ε-transition applies
  std::vector<std::size_t> by;  ///< transitions of this step that led to it, in order
};

/// A set of different configurations. The first leads. Settled ones come first, then by weight, then in the order in
/// which they were reached.
struct Exploration {
  std::vector<Branch> branches;
  int next_branch = 0;
  NextIds next;   ///< unique over all branches
  int steps = 0;  ///< transitions fired so far, over all branches
};

/// The events of a branch since the step began, in order; those before a fork are events of each branch after it.
struct BranchEvents {
  int branch = 0, parent = 0;
  std::vector<StepEvent> events;
};

struct ExplorationStep {
  Exploration after;
  std::vector<StepEvent> events;     ///< of the leading branch; or RefusedInput
  std::vector<StepEvent> made;       ///< the new symbols of the other branches, each once
  std::vector<BranchEvents> others;  ///< the other branches, without their symbols
  std::vector<int> dropped;          ///< branches that could not take the input while others could
  int merged = 0;                    ///< configurations that were reached once more
  int pruned = 0;                    ///< configurations dropped because the set was full, the lightest first
};

/// Steps the whole set, breadth first: from each configuration every transition that takes the input, then every chain
/// of ε-transitions, each both taken and not taken, as in the textbook. Equal results become one configuration with the
/// larger weight. At most `limit` are kept.
class Explorer {
 public:
  Explorer(Stepper stepper, std::size_t limit) : stepper_(std::move(stepper)), limit_(limit) {}

  ExplorationStep begin(const Facts& facts) const;
  /// Takes each of several inputs, weighted with its confidence. If no configuration takes any, the inputs are refused
  /// and the set stays. REQUIRES an input.
  ExplorationStep step(const Exploration& before, std::span<const Input> inputs, const Facts& facts) const;
  ExplorationStep step(const Exploration& before, const Input& input, const Facts& facts) const {
    return step(before, std::span(&input, 1), facts);
  }

 private:
  class Work;
  Stepper stepper_;
  std::size_t limit_;
};

}  // namespace continua
