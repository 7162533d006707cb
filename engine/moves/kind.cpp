#include "continua/moves/kind.h"

#include <algorithm>

#include "continua/moves/move.h"

namespace continua {
namespace {

bool is_taught(const InputEvent& gesture, const Learned& learned) {
  return learned.gestures.contains(gesture.name) && gesture.phase != "stop";
}

}  // namespace

std::string symbol_of(const InputEvent& event, const GestureCatalogue* gestures, const Learned& learned) {
  if (event.modality != Modality::gesture || !gestures) return symbol_of(event);
  if (is_taught(event, learned)) return name_of(Modality::gesture) + " " + iconic;
  return gesture_symbol(event, gestures->find(event.name));
}

std::string kind_of(const InputEvent& event, const Machine& machine, const GestureCatalogue* gestures,
                    const Learned& learned) {
  const auto symbol = symbol_of(event, gestures, learned);
  const auto found = std::find_if(machine.moves.begin(), machine.moves.end(),
                                  [&](const MoveKind& kind) { return kind.inputs.contains(symbol); });
  if (found != machine.moves.end()) return found->name;
  if (event.modality != Modality::gesture || !gestures) return {};
  if (is_taught(event, learned)) return iconic;
  const auto* entry = gestures->find(event.name);
  return entry && entry->acts(event.phase) ? entry->kind : std::string();
}

}  // namespace continua
