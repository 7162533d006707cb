#include "continua/replay/learn/estimate.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <string>

#include <fmt/format.h>

namespace continua {
namespace {

constexpr int rounds = 200;
constexpr double near_enough = 1e-9;
constexpr double pseudo_count = 1;
constexpr double least_level = 0.001;  // no evidence is worth nothing, and none is worth everything

double total_of(const Pick& pick, const std::vector<double>& weights) {
  double total = 0;
  for (const auto& [transition, confidence] : pick.rivals) total += confidence * weights[transition];
  return total;
}

double probability_of(const Way& way, const std::vector<double>& weights) {
  double probability = 1;
  for (const auto& pick : way.picks) {
    const auto& [transition, confidence] = pick.rivals[pick.taken];
    probability *= confidence * weights[transition] / total_of(pick, weights);
  }
  return probability;
}

double probability_of_match(const std::vector<Way>& ways, const std::vector<double>& weights) {
  double probability = 0;
  for (const auto& way : ways)
    if (way.matches) probability += probability_of(way, weights);
  return probability;
}

// The parts of the probability of an answer.
struct Parts {
  double sureness = 1;          // that the avatar is sure
  double sure = 0, unsure = 0;  // that it then answers as observed
  double all = 0;               // with what it may do otherwise
};

Parts parts_of(const AnsweredInput& input, const MachineWeights& weights, const Otherwise& otherwise) {
  Parts parts;
  for (const auto& [row, level] : input.evidence) parts.sureness *= weights.levels[row][level];
  parts.sure = probability_of_match(input.sure, weights.transitions);
  if (!input.evidence.empty()) parts.unsure = probability_of_match(input.unsure, weights.transitions);
  parts.all = (1 - otherwise.probability) * (parts.sureness * parts.sure + (1 - parts.sureness) * parts.unsure) +
              otherwise.probability * otherwise.each;
  return parts;
}

// The counts that the inputs are expected to give of each transition and level, under the present weights.
class Expectations {
 public:
  Expectations(const std::vector<AnsweredInput>& inputs, const MachineWeights& before, const Otherwise& otherwise)
      : inputs_(inputs), before_(before), otherwise_(otherwise) {
    for (const auto& input : inputs)
      for (const auto* ways : {&input.sure, &input.unsure})
        for (const auto& way : *ways)
          for (const auto& pick : way.picks) add_set(pick);
  }

  MachineWeights next(const MachineWeights& now) {
    taken_.assign(now.transitions.size(), 0);
    offered_ = taken_;
    level_seen_.clear();
    level_sure_.clear();
    for (const auto& input : inputs_) add(input, now);
    auto next = now;
    maximise_transitions(now, next);
    maximise_levels(next);
    return next;
  }

 private:
  void add_set(const Pick& pick) {
    std::set<std::size_t> transitions;
    for (const auto& rival : pick.rivals) transitions.insert(rival.first);
    if (transitions.size() > 1) sets_.insert(std::move(transitions));
  }

  void add(const AnsweredInput& input, const MachineWeights& now) {
    const auto parts = parts_of(input, now, otherwise_);
    const double explained = (1 - otherwise_.probability) / parts.all;
    const double sure = explained * parts.sureness, unsure = explained * (1 - parts.sureness);
    add_ways(input.sure, sure, now.transitions);
    if (input.evidence.empty()) return;
    add_ways(input.unsure, unsure, now.transitions);
    const double seen = sure * parts.sure + unsure * parts.unsure;
    if (!(seen > 0)) return;
    const double share = sure * parts.sure / seen;
    for (const auto& [row, level] : input.evidence) {
      // An avatar that is unsure of the whole may still be sure of this part of the evidence.
      const double alone = now.levels[row][level];
      const double spare = parts.sureness < 1 ? (alone - parts.sureness) / (1 - parts.sureness) : 0;
      level_seen_[{row, level}] += seen;
      level_sure_[{row, level}] += seen * (share + (1 - share) * spare);
    }
  }

  void add_ways(const std::vector<Way>& ways, double explained, const std::vector<double>& weights) {
    for (const auto& way : ways) {
      if (!way.matches) continue;
      const double share = explained * probability_of(way, weights);
      for (const auto& pick : way.picks) {
        taken_[pick.rivals[pick.taken].first] += share;
        const double total = total_of(pick, weights);
        for (const auto& [transition, confidence] : pick.rivals) offered_[transition] += share * confidence / total;
      }
    }
  }

  void maximise_transitions(const MachineWeights& now, MachineWeights& next) {
    for (const auto& set : sets_) {
      double before = 0, present = 0;
      for (const auto one : set) before += before_.transitions[one], present += now.transitions[one];
      for (const auto one : set) {
        taken_[one] += pseudo_count * before_.transitions[one] / before;
        offered_[one] += pseudo_count / present;
      }
    }
    for (std::size_t i = 0; i < taken_.size(); ++i)
      if (offered_[i] > 0 && taken_[i] > 0) next.transitions[i] = taken_[i] / offered_[i];
    keep_means(next.transitions);
  }

  // Weights are relative: those that were ever rivals keep their mean.
  void keep_means(std::vector<double>& weights) const {
    std::vector<std::size_t> group(weights.size());
    std::iota(group.begin(), group.end(), std::size_t{0});
    const std::function<std::size_t(std::size_t)> head = [&](std::size_t one) {
      return group[one] == one ? one : group[one] = head(group[one]);
    };
    for (const auto& set : sets_)
      for (const auto one : set) group[head(one)] = head(*set.begin());
    std::map<std::size_t, std::pair<double, double>> sums;
    for (std::size_t i = 0; i < weights.size(); ++i) {
      sums[head(i)].first += before_.transitions[i];
      sums[head(i)].second += weights[i];
    }
    for (std::size_t i = 0; i < weights.size(); ++i) {
      const auto& [before, now] = sums[head(i)];
      weights[i] *= before / now;
    }
  }

  void maximise_levels(MachineWeights& next) const {
    for (const auto& [at, seen] : level_seen_) {
      const auto [row, level] = at;
      const double sure = level_sure_.at(at) + pseudo_count * before_.levels[row][level];
      next.levels[row][level] = std::clamp(sure / (seen + pseudo_count), least_level, 1 - least_level);
    }
    // More evidence does not make less sure: levels that are out of order become the higher of the two.
    for (auto& levels : next.levels)
      for (std::size_t i = 1; i < levels.size(); ++i) levels[i] = std::max(levels[i], levels[i - 1]);
  }

  const std::vector<AnsweredInput>& inputs_;
  const MachineWeights& before_;
  const Otherwise& otherwise_;
  std::set<std::set<std::size_t>> sets_;  // of rivals
  std::vector<double> taken_, offered_;   // by transition
  std::map<std::pair<std::size_t, std::size_t>, double> level_seen_, level_sure_;
};

double difference(const MachineWeights& a, const MachineWeights& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.transitions.size(); ++i)
    most = std::max(most, std::abs(a.transitions[i] - b.transitions[i]));
  for (std::size_t i = 0; i < a.levels.size(); ++i)
    for (std::size_t k = 0; k < a.levels[i].size(); ++k)
      most = std::max(most, std::abs(a.levels[i][k] - b.levels[i][k]));
  return most;
}

// Six digits: the file is for people, and the last bits of sums are no knowledge.
double rounded(double value) { return std::stod(fmt::format("{:.6g}", value)); }

}  // namespace

Otherwise otherwise_of(const std::vector<AnsweredInput>& inputs, std::size_t different_answers) {
  const auto matches = [](const Way& way) { return way.matches; };
  const auto missed = std::count_if(inputs.begin(), inputs.end(), [&](const AnsweredInput& input) {
    return std::none_of(input.sure.begin(), input.sure.end(), matches) &&
           (input.evidence.empty() || std::none_of(input.unsure.begin(), input.unsure.end(), matches));
  });
  return {(static_cast<double>(missed) + 1) / (static_cast<double>(inputs.size()) + 2),
          1 / (static_cast<double>(different_answers) + 1)};
}

double log_likelihood(const std::vector<AnsweredInput>& inputs, const MachineWeights& weights,
                      const Otherwise& otherwise) {
  double sum = 0;
  for (const auto& input : inputs) sum += std::log(parts_of(input, weights, otherwise).all);
  return sum;
}

MachineWeights estimate(const std::vector<AnsweredInput>& inputs, const MachineWeights& before,
                        const Otherwise& otherwise) {
  Expectations expectations(inputs, before, otherwise);
  auto now = before;
  for (int round = 0; round < rounds; ++round) {
    auto next = expectations.next(now);
    const double moved = difference(now, next);
    now = std::move(next);
    if (moved < near_enough) break;
  }
  for (std::size_t i = 0; i < now.transitions.size(); ++i)
    if (now.transitions[i] != before.transitions[i]) now.transitions[i] = rounded(now.transitions[i]);
  for (std::size_t i = 0; i < now.levels.size(); ++i)
    for (std::size_t k = 0; k < now.levels[i].size(); ++k)
      if (now.levels[i][k] != before.levels[i][k]) now.levels[i][k] = rounded(now.levels[i][k]);
  return now;
}

}  // namespace continua
