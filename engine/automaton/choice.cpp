#include "continua/automaton/choice.h"

#include <algorithm>
#include <array>

namespace continua {
namespace {

constexpr std::array<std::pair<Choice, std::string_view>, 4> names = {{
    {Choice::likeliest, "likeliest"},
    {Choice::sample, "sample"},
    {Choice::unique, "unique"},
    {Choice::explore, "explore"},
}};

// Whether an input has several candidates. Candidates of one input are adjacent.
bool several_for_one(const std::vector<Candidate>& candidates) {
  return std::adjacent_find(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
           return a.alternative == b.alternative;
         }) != candidates.end();
}

bool lighter(const Candidate& a, const Candidate& b) { return a.weight < b.weight; }

}  // namespace

std::optional<Choice> parse_choice(std::string_view name) {
  for (const auto& [choice, known] : names)
    if (known == name) return choice;
  return std::nullopt;
}

std::string name_of(Choice choice) {
  for (const auto& [known, name] : names)
    if (known == choice) return std::string(name);
  return "";
}

std::string choice_names() {
  std::string all;
  for (std::size_t i = 0; i < names.size(); ++i)
    all += std::string(i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + std::string(names[i].second);
  return all;
}

std::optional<Chosen> Chooser::choose(const std::vector<Candidate>& candidates, const std::vector<Candidate>& outranked,
                                      const Configuration& configuration, std::span<const Input> inputs) {
  if (candidates.empty()) return std::nullopt;
  double total = 0;
  for (const auto& candidate : candidates) total += candidate.weight;
  // The draw is made where a choice is forced too, so that later draws stay those of the run without it.
  std::optional<double> draw;
  if (!outside && policy == Choice::sample && candidates.size() > 1) draw = random.uniform();
  const auto* chosen = take_forced(candidates);
  const bool ranked = chosen != nullptr;
  if (!chosen) chosen = take_forced(outranked);
  if (chosen) {
    ++steps;
    return Chosen{chosen->transition, ranked ? chosen->weight / total : 0, draw, true, chosen->alternative};
  }
  if (outside) {
    const auto taken = outside->choose({steps + 1, &configuration, inputs, candidates});
    if (taken) chosen = &candidates[*taken];
  } else if (draw) {
    double passed = 0;
    for (chosen = &candidates.front(); chosen != &candidates.back(); ++chosen)
      if ((passed += chosen->weight) > *draw * total) break;
  } else if (policy != Choice::unique || !several_for_one(candidates)) {
    chosen = &*std::max_element(candidates.begin(), candidates.end(), lighter);
  }
  if (!chosen) return std::nullopt;
  ++steps;
  return Chosen{chosen->transition, chosen->weight / total, draw, false, chosen->alternative};
}

// The heaviest of these that is forced at the next step; nullptr if none is.
const Candidate* Chooser::take_forced(const std::vector<Candidate>& from) {
  const auto wanted = forced.find(steps + 1);
  if (wanted == forced.end()) return nullptr;
  const Candidate* heaviest = nullptr;
  for (const auto& one : from)
    if (one.transition == wanted->second && (!heaviest || lighter(*heaviest, one))) heaviest = &one;
  if (heaviest) forced.erase(wanted);
  return heaviest;
}

}  // namespace continua
