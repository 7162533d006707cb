#include "continua/perception/gesture.h"

#include <algorithm>

namespace continua {

const std::string* GestureEntry::meaning(std::string_view direction) const {
  auto found = meanings.find(direction);
  if (found == meanings.end()) found = meanings.find("");
  return found == meanings.end() ? nullptr : &found->second;
}

bool GestureEntry::acts(std::string_view phase) const {
  return phase.empty() || std::find(acts_on.begin(), acts_on.end(), phase) != acts_on.end();
}

const GestureEntry* GestureCatalogue::find(std::string_view gesture) const {
  const auto found = entries.find(gesture);
  return found == entries.end() ? nullptr : &found->second;
}

std::string gesture_symbol(const InputEvent& event, const GestureEntry* entry) {
  const std::string symbol = name_of(Modality::gesture) + " " + (entry ? entry->kind : "unknown");
  const bool acts = entry ? entry->acts(event.phase) : event.phase != "stop";
  return acts ? symbol : symbol + " " + event.phase;
}

}  // namespace continua
