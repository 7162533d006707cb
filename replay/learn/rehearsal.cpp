#include "continua/replay/learn/rehearsal.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "continua/term/term_text.h"

namespace continua {
namespace {

constexpr std::size_t most_ways = 64;

// The machine, with all its evidence of one worth.
std::shared_ptr<const Machine> with_levels(const Machine& machine, double level) {
  auto changed = std::make_shared<Machine>(machine);
  for (auto& evidence : changed->beliefs.evidence) std::fill(evidence.levels.begin(), evidence.levels.end(), level);
  return changed;
}

// Takes the given numbers at the first picks, then the heaviest, and keeps all picks.
class Rehearsing : public OutsidePolicy {
 public:
  explicit Rehearsing(std::vector<std::size_t> numbers) : numbers_(std::move(numbers)) {}

  std::optional<std::size_t> choose(const OpenChoice& open) override {
    if (open.candidates.size() == 1) return 0;
    const auto heaviest = std::max_element(open.candidates.begin(), open.candidates.end(),
                                           [](const auto& a, const auto& b) { return a.weight < b.weight; });
    Pick pick;
    for (const auto& one : open.candidates)
      pick.rivals.emplace_back(one.transition, open.inputs.empty() ? 1 : open.inputs[one.alternative].confidence);
    pick.taken = picks_.size() < numbers_.size() ? std::min(numbers_[picks_.size()], pick.rivals.size() - 1)
                                                 : static_cast<std::size_t>(heaviest - open.candidates.begin());
    steps_[open.step] = pick.rivals[pick.taken].first;
    picks_.push_back(pick);
    return pick.taken;
  }

  const std::vector<Pick>& picks() const { return picks_; }
  const std::map<int, std::size_t>& steps() const { return steps_; }

 private:
  std::vector<std::size_t> numbers_;
  std::vector<Pick> picks_;
  std::map<int, std::size_t> steps_;
};

std::vector<AvatarMove> deeds_of(const Tick& tick) {
  std::vector<AvatarMove> deeds;
  for (const auto& event : tick.events) {
    const auto* step = std::get_if<StepEvent>(&event);
    if (!step) continue;
    if (const auto* said = std::get_if<Said>(step)) deeds.push_back({"speech", said->text});
    if (const auto* gestured = std::get_if<Gestured>(step)) deeds.push_back({"gesture", print(gestured->term)});
    if (const auto* acted = std::get_if<Acted>(step)) deeds.push_back({"action", print(acted->term)});
  }
  return deeds;
}

// The first input that the automaton took or refused.
std::string symbol_in(const Tick& tick) {
  for (const auto& event : tick.events) {
    const auto* step = std::get_if<StepEvent>(&event);
    const auto* fired = step ? std::get_if<Fired>(step) : nullptr;
    if (fired && fired->input) return *fired->input;
    if (const auto* refused = step ? std::get_if<RefusedInput>(step) : nullptr) return refused->input;
  }
  return "";
}

bool same_deeds(const std::vector<TriedWay>& a, const std::vector<TriedWay>& b) {
  const auto same_move = [](const AvatarMove& x, const AvatarMove& y) {
    return x.channel == y.channel && x.content == y.content;
  };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](const TriedWay& x, const TriedWay& y) {
    return std::equal(x.deeds.begin(), x.deeds.end(), y.deeds.begin(), y.deeds.end(), same_move);
  });
}

}  // namespace

Rehearsal::Rehearsal(const std::shared_ptr<const Machine>& machine, const std::shared_ptr<const Language>& language,
                     Perspective perspective)
    : own_(machine, language, perspective),
      sure_(with_levels(*machine, 1), language, perspective),
      unsure_(with_levels(*machine, 0), language, perspective) {}

std::vector<TriedWay> Rehearsal::ways(const Variant& variant, EngineState before, const InputEvent& event,
                                      const WorldSnapshot& world, std::string& symbol) const {
  before.beliefs = before.beliefs.carried_over(variant.machine->beliefs);
  before.chooser.forced.clear();
  std::vector<TriedWay> ways;
  std::vector<std::vector<std::size_t>> open{{}};
  while (!open.empty() && ways.size() < most_ways) {
    const auto numbers = std::move(open.back());
    open.pop_back();
    const auto policy = std::make_shared<Rehearsing>(numbers);
    before.chooser.outside = policy;
    Tick tick = variant.pipeline.tick(before, event, world);
    tick.then(variant.pipeline.settle(tick.after, world));
    if (ways.empty()) symbol = symbol_in(tick);
    const auto& picks = policy->picks();
    std::vector<std::size_t> taken;
    for (std::size_t i = 0; i < picks.size(); ++i) {
      for (std::size_t other = 0; i >= numbers.size() && other < picks[i].rivals.size(); ++other) {
        if (other == picks[i].taken) continue;
        open.push_back(taken);
        open.back().push_back(other);
      }
      taken.push_back(picks[i].taken);
    }
    ways.push_back({{picks, false}, deeds_of(tick), policy->steps()});
  }
  return ways;
}

// The levels to which the input raises its concepts, of the rows that could make a difference.
std::vector<EvidenceLevel> Rehearsal::evidence_of(const std::string& symbol, const Beliefs& beliefs) const {
  const auto& table = own_.machine->beliefs;
  auto raised = beliefs.carried_over(table);
  const auto changes = raised.raise(symbol);
  std::vector<EvidenceLevel> found;
  for (std::size_t row = 0; row < table.evidence.size(); ++row) {
    const auto& evidence = table.evidence[row];
    if (!evidence.inputs.contains(symbol) || evidence.concepts.empty()) continue;
    const auto& first = table.concepts[evidence.concepts.front()];
    if (first.fixed) continue;
    std::size_t level = evidence.levels.size() - 1;
    for (const auto& change : changes)
      if (change.name == first.name)
        level = static_cast<std::size_t>(std::find(evidence.levels.begin(), evidence.levels.end(), change.value) -
                                         evidence.levels.begin());
    if (level < evidence.levels.size()) found.push_back({row, level});
  }
  return found;
}

Rehearsed Rehearsal::rehearse(const EngineState& before, const InputEvent& event, const WorldSnapshot& world) const {
  Rehearsed rehearsed;
  std::string symbol;
  rehearsed.sure = ways(own_, before, event, world, symbol);
  auto evidence = evidence_of(symbol, before.beliefs);
  if (evidence.empty()) return rehearsed;
  auto sure = ways(sure_, before, event, world, symbol);
  auto unsure = ways(unsure_, before, event, world, symbol);
  if (same_deeds(sure, unsure)) return rehearsed;
  return {std::move(sure), std::move(unsure), std::move(evidence)};
}

}  // namespace continua
