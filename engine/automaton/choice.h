// Policies that choose among applicable transitions (SEMANTICS.md §1, Nondeterminism).
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
  unique,     ///< the input's only one; none if an input has several; with several inputs, the heaviest
  explore,    ///< all of them: automaton/exploration.h
};

std::optional<Choice> parse_choice(std::string_view name);
std::string name_of(Choice choice);
/// "likeliest, sample, unique or explore", for messages.
std::string choice_names();

struct Candidate {
  std::size_t transition = 0;   ///< index in Machine::transitions
  double weight = 1;            ///< the transition's weight times the input's confidence; > 0
  std::size_t alternative = 0;  ///< number of the input that it takes, among those offered
};

struct Chosen {
  std::size_t transition = 0;
  double probability = 1;      ///< its share of all weights
  std::optional<double> draw;  ///< in [0, 1), if a draw was needed
  bool forced = false;
  std::size_t alternative = 0;  ///< number of the input that it takes, among those offered
};

/// Takes the decisions of a run, one after another. A value that counts its decisions.
struct Chooser {
  Choice policy = Choice::likeliest;
  Random random{0};
  std::map<int, std::size_t> forced;  ///< step → transition; taken entries are erased
  int steps = 0;                      ///< transitions chosen so far; the first is step 1

  /// `candidates` are ordered by alternative, then in file order. Returns nothing without candidates, and under
  /// `unique` if an input has more than one. A transition that is forced at this step is taken if it is a candidate,
  /// with the input that makes it heaviest; if not, it stays in `forced` and the policy decides. Under `explore` this
  /// takes the heaviest, because it returns only one.
  std::optional<Chosen> choose(const std::vector<Candidate>& candidates);
};

}  // namespace continua
