#include "automaton/choice.h"

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

}  // namespace

std::optional<Choice> parse_choice(std::string_view name) {
  for (const auto& [choice, known] : names)
    if (known == name) return choice;
  return std::nullopt;
}

std::string text(Choice choice) {
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

std::optional<Chosen> Chooser::choose(const std::vector<Candidate>& candidates) {
  const auto wanted = forced.find(steps + 1);
  auto chosen = candidates.end();
  if (wanted != forced.end())
    chosen = std::find_if(candidates.begin(), candidates.end(),
                          [&](const Candidate& one) { return one.transition == wanted->second; });
  const bool is_forced = chosen != candidates.end();
  if (candidates.empty() || (!is_forced && policy == Choice::unique && candidates.size() > 1)) return std::nullopt;

  double total = 0;
  for (const auto& candidate : candidates) total += candidate.weight;
  std::optional<double> draw;
  if (policy == Choice::sample && candidates.size() > 1) draw = random.uniform();
  if (is_forced) {
    forced.erase(wanted);
  } else if (draw) {
    double passed = 0;
    for (chosen = candidates.begin(); chosen + 1 != candidates.end(); ++chosen)
      if ((passed += chosen->weight) > *draw * total) break;
  } else {
    chosen = std::max_element(candidates.begin(), candidates.end(),
                              [](const auto& a, const auto& b) { return a.weight < b.weight; });
  }
  ++steps;
  return Chosen{chosen->transition, total > 0 ? chosen->weight / total : 1, draw, is_forced};
}

}  // namespace continua
