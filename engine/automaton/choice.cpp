#include "automaton/choice.h"

#include <algorithm>

namespace continua {

std::optional<Choice> parse_choice(std::string_view name) {
  for (const auto choice : {Choice::likeliest, Choice::sample, Choice::unique})
    if (text(choice) == name) return choice;
  return std::nullopt;
}

std::string text(Choice choice) {
  switch (choice) {
    case Choice::likeliest:
      return "likeliest";
    case Choice::sample:
      return "sample";
    case Choice::unique:
      return "unique";
  }
  return "";
}

std::optional<Chosen> choose(const std::vector<Candidate>& candidates, Choice choice, Random& random) {
  if (candidates.empty() || (choice == Choice::unique && candidates.size() > 1)) return std::nullopt;
  double total = 0;
  for (const auto& candidate : candidates) total += candidate.weight;
  auto chosen = std::max_element(candidates.begin(), candidates.end(),
                                 [](const auto& a, const auto& b) { return a.weight < b.weight; });
  std::optional<double> draw;
  if (choice == Choice::sample && candidates.size() > 1) {
    draw = random.uniform();
    double passed = 0;
    for (chosen = candidates.begin(); chosen + 1 != candidates.end(); ++chosen)
      if ((passed += chosen->weight) > *draw * total) break;
  }
  return Chosen{chosen->transition, total > 0 ? chosen->weight / total : 1, draw};
}

}  // namespace continua
