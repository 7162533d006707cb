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

std::optional<Chosen> Chooser::choose(const std::vector<Candidate>& candidates) {
  const auto lighter = [](const Candidate& a, const Candidate& b) { return a.weight < b.weight; };
  const auto wanted = forced.find(steps + 1);
  auto chosen = candidates.end();
  if (wanted != forced.end())
    for (auto one = candidates.begin(); one != candidates.end(); ++one)
      if (one->transition == wanted->second && (chosen == candidates.end() || lighter(*chosen, *one))) chosen = one;
  const bool is_forced = chosen != candidates.end();
  if (candidates.empty() || (!is_forced && policy == Choice::unique && several_for_one(candidates)))
    return std::nullopt;

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
    chosen = std::max_element(candidates.begin(), candidates.end(), lighter);
  }
  ++steps;
  return Chosen{chosen->transition, chosen->weight / total, draw, is_forced, chosen->alternative};
}

}  // namespace continua
