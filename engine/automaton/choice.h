// The choice among several applicable transitions (SEMANTICS.md §1, Nondeterminism).
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/random.h"

namespace continua {

enum class Choice {
  likeliest,  ///< the heaviest; ties by alternative, then file order
  sample,     ///< a seeded draw by weight
  unique,     ///< the only transition of an input; none if one input has several; of several inputs, the heaviest one's
  explore,    ///< all of them: automaton/exploration.h
};

std::optional<Choice> parse_choice(std::string_view name);
std::string name_of(Choice choice);
/// "likeliest, sample, unique or explore", for messages.
std::string choice_names();

struct Candidate {
  std::size_t transition = 0;   ///< index in Machine::transitions
  double weight = 1;            ///< the transition's times the input's confidence; > 0
  std::size_t alternative = 0;  ///< which of the inputs offered it takes
};

struct Chosen {
  std::size_t transition = 0;
  double probability = 1;      ///< its share of all weights
  std::optional<double> draw;  ///< in [0, 1), where one was needed
  bool forced = false;
  std::size_t alternative = 0;  ///< which of the inputs offered it takes
};

/// Takes the decisions of a run, one after another: a value that remembers how many it took.
struct Chooser {
  Choice policy = Choice::likeliest;
  Random random{0};
  std::map<int, std::size_t> forced;  ///< step → transition; erased once taken
  int steps = 0;                      ///< transitions chosen so far; the first is step 1

  /// `candidates` by alternative, then in file order. Nothing without a candidate, or under `unique` with more than one
  /// for the same input. A transition that is forced at this step is taken if it is among them, for the input that
  /// makes it heaviest; if not, it stays in `forced` and the policy decides.
  /// Under `explore` the heaviest is taken, since a single one is asked for.
  std::optional<Chosen> choose(const std::vector<Candidate>& candidates);
};

}  // namespace continua
