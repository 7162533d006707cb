// Policies that choose among applicable transitions (SEMANTICS.md §1, Nondeterminism).
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "continua/automaton/configuration.h"
#include "continua/automaton/input.h"
#include "continua/core/random.h"
#include "continua/core/result.h"

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
  double probability = 1;      ///< its share of the candidates' weights; 0 if it was outranked
  std::optional<double> draw;  ///< in [0, 1), if a draw was needed
  bool forced = false;
  std::size_t alternative = 0;  ///< number of the input that it takes, among those offered
};

/// The moment at which one of several transitions is to be chosen.
struct OpenChoice {
  int step = 0;  ///< the number that the chosen transition will have
  const Configuration* configuration = nullptr;
  std::span<const Input> inputs;          ///< those offered; none: ε
  std::span<const Candidate> candidates;  ///< at least one; by alternative, then in file order
};

/// A policy from outside of the engine. It must answer the same questions in the same way, if runs are to be the same.
class OutsidePolicy {
 public:
  virtual ~OutsidePolicy() = default;
  /// A run begins: what was asked before does not count.
  virtual void begin() {}
  /// The number of a candidate, or nothing where none is to be taken.
  virtual std::optional<std::size_t> choose(const OpenChoice& open) = 0;
  /// The reason why it can choose no more; the run is to end then.
  virtual Outcome trouble() const { return std::nullopt; }
};

/// Takes the decisions of a run, one after another. A value that counts its decisions.
struct Chooser {
  Choice policy = Choice::likeliest;
  Random random{0};
  std::map<int, std::size_t> forced;            ///< step → transition; taken entries are erased
  int steps = 0;                                ///< transitions chosen so far; the first is step 1
  std::shared_ptr<OutsidePolicy> outside = {};  ///< decides in place of `policy`, unless that is `explore`

  /// `candidates` are ordered by alternative, then in file order. Returns nothing without candidates, and under
  /// `unique` if an input has more than one. A transition that is forced at this step is taken if it is a candidate or
  /// `outranked`, with the input that makes it heaviest; if not, it stays in `forced` and the policy decides. Under
  /// `explore` this takes the heaviest, because it returns only one.
  std::optional<Chosen> choose(const std::vector<Candidate>& candidates, const std::vector<Candidate>& outranked,
                               const Configuration& configuration, std::span<const Input> inputs);

 private:
  const Candidate* take_forced(const std::vector<Candidate>& from);
};

}  // namespace continua
