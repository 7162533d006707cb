// Which of several applicable transitions is taken (semantics §1, Nondeterminism).
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/random.h"

namespace continua {

enum class Choice {
  likeliest,  ///< the heaviest; ties by file order
  sample,     ///< a seeded draw by weight
  unique,     ///< the only one; of several, none
};

std::optional<Choice> parse_choice(std::string_view name);
std::string text(Choice choice);

struct Candidate {
  std::size_t transition = 0;  ///< index in Machine::transitions
  double weight = 1;           ///< the transition's times the input's confidence; > 0
};

struct Chosen {
  std::size_t transition = 0;
  double probability = 1;      ///< its share of all weights
  std::optional<double> draw;  ///< in [0, 1), where one was needed
};

/// `candidates` in file order. Nothing where there is none, or under `unique` more than one.
std::optional<Chosen> choose(const std::vector<Candidate>& candidates, Choice choice, Random& random);

}  // namespace continua
