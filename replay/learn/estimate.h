// Weights of transitions and levels of evidence, estimated from what another avatar did: expectation maximisation
// (Dempster, Laird & Rubin 1977) around the choice model of Luce (1959), whose maximisation step is that of Hunter
// (2004, MM algorithms for generalized Bradley-Terry models).
//
// An avatar answers an input in one of several ways. A way makes picks: at each it took one of rival transitions, with
// the probability of its weight (times the confidence of its input) among theirs. Where an input is evidence, the ways
// are those of an avatar that is sure of it, with the probability that is the product of the levels, and else those of
// one that is unsure. With a small probability an avatar does something else altogether.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "continua/machine_file/machine_weights.h"

namespace continua {

struct Pick {
  std::vector<std::pair<std::size_t, double>>
      rivals;             ///< transitions, and the confidences of their inputs; two or more
  std::size_t taken = 0;  ///< the number of a rival
};

struct Way {
  std::vector<Pick> picks;
  bool matches = false;  ///< its deeds agree with what was observed
};

/// A level of a row of Machine::beliefs' evidence, both from 0.
struct EvidenceLevel {
  std::size_t row = 0, level = 0;
};

/// An input, and the ways in which it may be answered.
struct AnsweredInput {
  std::vector<Way> sure, unsure;        ///< `unsure` counts only with `evidence`
  std::vector<EvidenceLevel> evidence;  ///< empty: it makes no difference
};

/// The probability that an avatar does something else, and that of each thing that it may do then.
struct Otherwise {
  double probability = 0.05, each = 0.01;
};

/// Of inputs that answers are known for; `different_answers`: the number of different ones among them.
Otherwise otherwise_of(const std::vector<AnsweredInput>& inputs, std::size_t different_answers);

/// The natural logarithm of the probability of all observed answers.
double log_likelihood(const std::vector<AnsweredInput>& inputs, const MachineWeights& weights,
                      const Otherwise& otherwise);

/// The likeliest weights and levels, smoothed: each set of rivals and each level counts as if it had been observed once
/// more, with the outcome that `before` expects. Those that no input tells of stay. Rivals keep the mean of their
/// weights.
MachineWeights estimate(const std::vector<AnsweredInput>& inputs, const MachineWeights& before,
                        const Otherwise& otherwise);

}  // namespace continua
