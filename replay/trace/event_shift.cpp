#include "continua/replay/trace/event_shift.h"

namespace continua {

Json shifted_event(Json event, SimTime by) {
  const auto shift = [&](Json& object, const char* member) {
    const auto found = object.find(member);
    if (found != object.end() && found->is_number())
      *found = (SimTime::from_seconds(found->get<double>()) + by).seconds();
  };
  for (const char* member : {"t", "happened", "until"}) shift(event, member);
  if (const auto words = event.find("words"); words != event.end() && words->is_array())
    for (auto& word : *words)
      if (word.is_object()) shift(word, "t");
  return event;
}

}  // namespace continua
