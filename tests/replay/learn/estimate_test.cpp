#include "continua/replay/learn/estimate.h"

#include <cmath>

#include "support/catch.h"

namespace continua {
namespace {

const MachineWeights even{{1, 1, 1}, {{0.5, 1}}};
const Otherwise hardly{1e-6, 0.01};

Way way(std::vector<std::pair<std::size_t, double>> rivals, std::size_t taken, bool matches) {
  return {{{std::move(rivals), taken}}, matches};
}

// An avatar that had the transitions 0 and 1, and took `taken`.
AnsweredInput choice(std::size_t taken) {
  return {{way({{0, 1}, {1, 1}}, 0, taken == 0), way({{0, 1}, {1, 1}}, 1, taken == 1)}, {}, {}};
}

AnsweredInput evidence(bool sure, std::size_t level = 0) { return {{{{}, sure}}, {{{}, !sure}}, {{0, level}}}; }

std::vector<AnsweredInput> repeated(const AnsweredInput& one, int count) {
  return std::vector<AnsweredInput>(static_cast<std::size_t>(count), one);
}

std::vector<AnsweredInput> joined(std::vector<AnsweredInput> a, const std::vector<AnsweredInput>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

}  // namespace

TEST_CASE("Weights become the shares in which rivals were taken") {
  const auto inputs = joined(repeated(choice(0), 29), repeated(choice(1), 10));
  const auto after = estimate(inputs, even, hardly);
  // 29 and 10, and half a time more each, of 40.
  CHECK(after.transitions[0] / after.transitions[1] == Approx(29.5 / 10.5).epsilon(1e-3));
  CHECK(after.transitions[0] + after.transitions[1] == Approx(2).epsilon(1e-4));
  CHECK(after.transitions[2] == 1);
  CHECK(after.levels == even.levels);
  CHECK(log_likelihood(inputs, after, hardly) > log_likelihood(inputs, even, hardly));
}

TEST_CASE("Sets of rivals that overlap are estimated together") {
  // 0 beats 1 three times of four, 1 beats 2 three times of four.
  std::vector<AnsweredInput> inputs;
  for (const auto& [first, second] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}})
    for (int i = 0; i < 400; ++i) {
      const bool wins = i % 4 != 0;
      inputs.push_back({{way({{first, 1}, {second, 1}}, 0, wins), way({{first, 1}, {second, 1}}, 1, !wins)}, {}, {}});
    }
  const auto after = estimate(inputs, even, hardly);
  CHECK(after.transitions[0] / after.transitions[1] == Approx(3).epsilon(0.02));
  CHECK(after.transitions[1] / after.transitions[2] == Approx(3).epsilon(0.02));
}

TEST_CASE("The confidence of an input is no weight") {
  // The input of transition 0 is twice as sure, and it was taken twice as often: the weights are equal.
  std::vector<AnsweredInput> inputs;
  for (int i = 0; i < 300; ++i)
    inputs.push_back({{way({{0, 1}, {1, 0.5}}, 0, i % 3 != 0), way({{0, 1}, {1, 0.5}}, 1, i % 3 == 0)}, {}, {}});
  const auto after = estimate(inputs, even, hardly);
  CHECK(after.transitions[0] / after.transitions[1] == Approx(1).epsilon(0.01));
}

TEST_CASE("A level becomes the share of inputs of which the avatar was sure") {
  const auto inputs = joined(repeated(evidence(true), 2), repeated(evidence(false), 17));
  const auto after = estimate(inputs, even, hardly);
  CHECK(after.levels[0][0] == Approx(2.5 / 20).epsilon(1e-3));
  CHECK(after.levels[0][1] == 1);
  CHECK(after.transitions == even.transitions);
}

TEST_CASE("Levels stay in ascending order") {
  const auto inputs = joined(repeated(evidence(true, 0), 50), repeated(evidence(false, 1), 50));
  const auto after = estimate(inputs, even, hardly);
  CHECK(after.levels[0][0] <= after.levels[0][1]);
}

TEST_CASE("What nothing explains changes nothing") {
  const std::vector<AnsweredInput> inputs{{{{{}, false}}, {}, {}}, {{way({{0, 1}, {1, 1}}, 0, false)}, {}, {}}};
  const auto otherwise = otherwise_of(inputs, 3);
  CHECK(otherwise.probability == Approx(0.75));
  CHECK(otherwise.each == Approx(0.25));
  const auto after = estimate(inputs, even, otherwise);
  CHECK(after.transitions[0] == Approx(1));
  CHECK(after.levels == even.levels);
  CHECK(log_likelihood(inputs, even, otherwise) == Approx(2 * std::log(0.75 * 0.25)));
}

TEST_CASE("Without inputs there is nothing to learn") {
  const auto after = estimate({}, even, otherwise_of({}, 0));
  CHECK(after.transitions == even.transitions);
  CHECK(after.levels == even.levels);
}

}  // namespace continua
