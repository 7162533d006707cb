#include "replay/live/live_setup.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace continua {
namespace {

Json button(const InputEvent& gesture, const std::string& about) {
  Json event{{"kind", "gesture"}, {"name", gesture.name}};
  std::string label = gesture.name;
  for (const auto& [key, value] : {std::pair("hand", gesture.hand), std::pair("direction", gesture.direction),
                                   std::pair("phase", gesture.phase)}) {
    if (value.empty()) continue;
    event[key] = value;
    if (value != "stroke") label += " " + value;
  }
  return {{"label", label}, {"about", about}, {"event", std::move(event)}};
}

}  // namespace

Result<Json> live_setup(const DataPaths& data) {
  const auto read = LocatedJson::read((data.knowledge / "live.json").string());
  if (!read) return read.error();
  const Json& defaults = read->root();
  Json setup{{"scenes", names_in(data.mjcf / "scenes", ".xml")},
             {"machines", names_in(data.knowledge / "machines", ".json")}};
  for (const char* field : {"scene", "machine", "buttons"}) {
    if (!defaults.contains(field)) return read->error("", fmt::format("found no '{}'", field));
    setup[field] = defaults[field];
  }
  return setup;
}

Json gesture_palette(const Machine& machine, const GestureCatalogue* gestures) {
  Json palette = Json::array();
  if (gestures) {
    for (const auto& [name, entry] : gestures->entries) {
      InputEvent gesture;
      gesture.name = name;
      gesture.phase = entry.acts_on.empty() || entry.acts("stroke") ? "stroke" : entry.acts_on.front();
      if (entry.meanings.empty() || entry.meanings.contains("")) palette.push_back(button(gesture, entry.about));
      for (const auto& [direction, meaning] : entry.meanings) {
        if (direction.empty()) continue;
        gesture.direction = direction;
        palette.push_back(button(gesture, entry.about));
      }
    }
    return palette;
  }
  std::set<std::string> symbols;
  for (const auto& transition : machine.transitions)
    if (transition.on) symbols.insert(transition.on->names.begin(), transition.on->names.end());
  for (const auto& symbol : symbols)
    if (const auto event = event_of(symbol); event.modality == Modality::gesture) palette.push_back(button(event, ""));
  return palette;
}

}  // namespace continua
