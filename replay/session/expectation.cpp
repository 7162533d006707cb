#include "continua/replay/session/expectation.h"

#include <algorithm>

#include "continua/term/term_text.h"

namespace continua {
namespace {

constexpr const char* nothing = "null";

// The slot of that name of the topmost symbol as text; "null" where the machine has no such slot.
std::string slot_text(const Situation& situation, std::string_view name) {
  const auto slot = situation.machine.slot_index.find(name);
  return slot == situation.machine.slot_index.end() ? nothing
                                                    : print(situation.configuration.stack.top()[slot->second].value);
}

// The elements of the first slot of the topmost symbol that holds a list: the candidates of a machine without lexicon.
std::vector<std::string> listed(const Situation& situation) {
  std::vector<std::string> names;
  const auto& slots = situation.machine.slots;
  const auto slot =
      std::find_if(slots.begin(), slots.end(), [](const Slot& each) { return each.type.kind() == Type::Kind::list; });
  if (slot == slots.end()) return names;
  const auto index = static_cast<std::size_t>(slot - slots.begin());
  const auto& value = situation.configuration.stack.top()[index].value;
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
  constexpr const char* indicated = "indicated";
  compare(indicated, expectation.indicated, slot_text(situation, indicated));
  compare("referents", expectation.referents,
          situation.machine.lexicon.empty() ? listed(situation) : situation.referents);
  compare("act", expectation.act, situation.last_act.empty() ? std::string(nothing) : situation.last_act);
  compare("holding", expectation.holding, situation.world.held.empty() ? std::string(nothing) : situation.world.held);
  compare("stack_depth", expectation.stack_depth, static_cast<std::int64_t>(situation.configuration.stack.depth()));
  return checked;
}

}  // namespace continua
