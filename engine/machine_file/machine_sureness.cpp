#include "continua/machine_file/machine_sureness.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "continua/machine_file/machine_keys.h"

namespace continua {
namespace {

constexpr double longest_half_life_s = 60;

// Gestures that neither take nor move anything.
constexpr std::array<std::string_view, 3> looks = {"look_at", "reach", "point"};

bool only_looks(const std::vector<Effect>& effects) {
  return std::all_of(effects.begin(), effects.end(), [](const Effect& effect) {
    if (const auto* group = std::get_if<Group>(&effect.what)) return only_looks(group->effects);
    const auto* gesture = std::get_if<Gesture>(&effect.what);
    if (!gesture) return false;
    const auto [head, arguments] = gesture->term.spine();
    return head.kind() == Term::Kind::constant && std::find(looks.begin(), looks.end(), head.name()) != looks.end();
  });
}

// Entering a state may also put the stack or a register right, as when the hand is read from the world.
bool is_quiet(const std::vector<Effect>& effects) {
  return std::all_of(effects.begin(), effects.end(), [](const Effect& effect) {
    return std::holds_alternative<Rewrite>(effect.what) || std::holds_alternative<Remember>(effect.what) ||
           only_looks({effect});
  });
}

bool has_epsilon(const Machine& machine, StateIndex state) {
  return std::any_of(machine.transitions.begin(), machine.transitions.end(), [&](const Transition& each) {
    return !each.on && std::find(each.from.begin(), each.from.end(), state) != each.from.end();
  });
}

// The reason why the transition does more than look; empty if it does not.
std::string does_more(const Transition& transition, const Machine& machine) {
  const auto& state = machine.states[transition.to];
  if (transition.from != std::vector<StateIndex>{transition.to}) return "it leads to another state";
  if (transition.operation.kind != Operation::Kind::none) return "it changes the stack";
  if (!only_looks(transition.effects)) return "it has other effects than look_at, reach and point";
  if (!is_quiet(state.enter)) return fmt::format("{} has other effects when it is entered", state.name);
  if (has_epsilon(machine, transition.to)) return fmt::format("an ε-transition leads on from {}", state.name);
  return "";
}

}  // namespace

std::vector<Thresholds> read_confidence(const Item& item, SymbolReader& symbols) {
  std::vector<Thresholds> rows;
  for (const auto& [key, entry] : item.members("confidences by input symbols or sets")) {
    if (!expect_kind(entry, "confidences")) continue;
    Thresholds row;
    row.inputs = symbols.symbols_of_key(key, entry);
    row.confirm = entry.member("confirm").number("a confidence", 0, 0, 1);
    row.ignore = entry.member("ignore").number("a confidence", 0, 0, 1);
    if (entry.member("confirm").exists() && row.confirm > 0 && row.confirm <= row.ignore)
      entry.member("confirm").problem(fmt::format("nothing is confirmed: what is below {} is ignored", row.ignore));
    rows.push_back(std::move(row));
  }
  return rows;
}

std::optional<GazeTimes> read_gaze(const Item& item) {
  if (!item.exists() || !expect_kind(item, "the fading of looks")) return std::nullopt;
  GazeTimes times;
  const auto half_life = item.member("half_life");
  times.half_life_s = half_life.number("seconds", times.half_life_s, 0, longest_half_life_s);
  if (times.half_life_s == 0) half_life.mismatch("seconds, a number greater than 0");
  times.least = item.member("least").number("seconds", times.least, 0, longest_half_life_s);
  return times;
}

void check_sureness(const Machine& machine, const Item& root) {
  const bool asks = machine.knows_input("unsure");
  constexpr const char* unasked = "nothing is asked about: no transition takes 'unsure'";
  if (const auto near_tie = root.member("near_tie"); near_tie.exists() && !asks) near_tie.problem_at_key(unasked);
  for (const auto& [key, entry] : root.member("confidence").members("confidences"))
    if (const auto confirm = entry.member("confirm"); confirm.exists() && !asks) confirm.problem_at_key(unasked);
  for (const auto& item : root.member("transitions").elements("the transitions")) {
    const auto id = item.member("id");
    if (!id.is_text()) continue;
    const auto& name = id.json().get_ref<const std::string&>();
    const auto found = std::find_if(machine.transitions.begin(), machine.transitions.end(),
                                    [&](const Transition& each) { return each.id == name; });
    if (found == machine.transitions.end() || !found->on || !found->on->contains("interim")) continue;
    if (const auto why = does_more(*found, machine); !why.empty())
      item.member("on").problem(
          fmt::format("words that are not final ('interim') may only start a look, a reach or a point, but {}", why));
  }
}

}  // namespace continua
