#include "continua/replay/session/expectation.h"

#include "continua/term/term_text.h"

namespace continua {
namespace {

constexpr const char* nothing = "null";

// A slot of the topmost symbol as text; "null" where the machine has no such slot.
std::string slot_text(const Situation& situation, std::string_view name) {
  const auto slot = situation.machine.slot_index.find(name);
  return slot == situation.machine.slot_index.end() ? nothing
                                                    : print(situation.configuration.stack.top()[slot->second].value);
}

std::vector<std::string> slot_list(const Situation& situation, std::string_view name) {
  std::vector<std::string> names;
  const auto slot = situation.machine.slot_index.find(name);
  if (slot == situation.machine.slot_index.end()) return names;
  const auto& value = situation.configuration.stack.top()[slot->second].value;
  if (value.kind() == Term::Kind::list)
    for (const auto& element : value.elements()) names.push_back(print(element));
  return names;
}

}  // namespace

Checked check(const Expectation& expectation, const Situation& situation) {
  Checked checked{true, Json::object()};
  const auto compare = [&](const char* field, const auto& expected, const auto& found) {
    if (!expected) return;
    checked.found[field] = found;
    checked.met = checked.met && *expected == found;
  };
  compare("state", expectation.state, situation.machine.states[situation.configuration.state].name);
  compare("says", expectation.says, situation.said.empty() ? std::string(nothing) : situation.said.back());
  compare("indicated", expectation.indicated, slot_text(situation, "indicated"));
  compare("referents", expectation.referents,
          situation.machine.lexicon.empty() ? slot_list(situation, "options") : situation.referents);
  compare("act", expectation.act, situation.last_act.empty() ? std::string(nothing) : situation.last_act);
  compare("holding", expectation.holding, situation.world.held.empty() ? std::string(nothing) : situation.world.held);
  compare("stack_depth", expectation.stack_depth, static_cast<std::int64_t>(situation.configuration.stack.depth()));
  return checked;
}

}  // namespace continua
