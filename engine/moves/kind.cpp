#include "continua/moves/kind.h"

#include <algorithm>

#include "continua/moves/move.h"

namespace continua {
namespace {

std::string kind_of_meaning(const Term& meaning) {
  const bool is_thing = meaning.type() == Type::entity() || meaning.type() == Type::list(Type::entity());
  return is_thing ? static_iconic : iconic;
}

}  // namespace

KnownGesture known_gesture(const InputEvent& event, const GestureCatalogue* gestures, const Learned& learned) {
  KnownGesture known;
  if (event.modality != Modality::gesture || !gestures) return known;
  const bool ends = event.phase == "stop";
  auto lesson = learned.gestures.find(event.name);
  if (lesson == learned.gestures.end()) known.entry = gestures->find(event.name);
  if (!ends && !event.features.empty() && lesson != learned.gestures.end()) {
    known.shape = by_name(event.name, event.features, learned);
  } else if (!ends && !known.entry && !event.features.empty()) {
    known.shape = recognise(event.features, learned, gestures->shapes);
    if (known.shape->verdict == Recognition::Verdict::recognised)
      lesson = learned.gestures.find(known.shape->nearest->gesture);
  }
  if (lesson == learned.gestures.end() || ends) return known;
  known.taught = &lesson->second;
  known.lesson = lesson->first;
  return known;
}

std::string symbol_of(const InputEvent& event, const GestureCatalogue* gestures, const Learned& learned) {
  if (event.modality != Modality::gesture || !gestures) return symbol_of(event);
  const auto known = known_gesture(event, gestures, learned);
  if (known.taught) return name_of(Modality::gesture) + " " + kind_of_meaning(*known.taught);
  return gesture_symbol(event, gestures->find(event.name));
}

std::string kind_of(const InputEvent& event, const Machine& machine, const GestureCatalogue* gestures,
                    const Learned& learned) {
  const auto symbol = symbol_of(event, gestures, learned);
  const auto found = std::find_if(machine.moves.begin(), machine.moves.end(),
                                  [&](const MoveKind& kind) { return kind.inputs.contains(symbol); });
  if (found != machine.moves.end()) return found->name;
  if (event.modality != Modality::gesture || !gestures) return {};
  const auto known = known_gesture(event, gestures, learned);
  if (known.taught) return kind_of_meaning(*known.taught);
  const auto* entry = known.entry;
  return entry && entry->acts(event.phase) ? entry->kind : std::string();
}

}  // namespace continua
