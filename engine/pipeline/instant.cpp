#include "continua/pipeline/instant.h"

#include <string>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/moves/kind.h"

namespace continua {
namespace {

enum Rank { pointing_gesture, sample, pointing_hand, before_words, the_rest };

Rank rank_of(const Engine& engine, const EngineState& state, const InputEvent& event) {
  if (event.modality == Modality::pointing || event.modality == Modality::gaze) return sample;
  if (event.modality == Modality::speech) return event.final ? the_rest : sample;
  if (kind_of(event, *engine.machine, gestures_of(engine), state.learned) == deixis)
    return place_of(event) ? pointing_gesture : pointing_hand;
  return known_gesture(event, gestures_of(engine), state.learned).comes_before_words() ? before_words : the_rest;
}

std::string content_of(const Vec3& p) { return fmt::format("{} {} {}", p.x(), p.y(), p.z()); }

// All that tells two events apart, as a text.
std::string content_of(const InputEvent& event) {
  std::string content = fmt::format("{} {} {} {} {} {} {}", name_of(event.modality), event.text, event.name, event.hand,
                                    event.direction, event.phase, event.until.value_or(event.t).us);
  if (event.target_W) content += " at " + content_of(*event.target_W);
  if (event.ray) content += " along " + content_of(event.ray->from_W) + " " + content_of(event.ray->direction_W);
  content += fmt::format(" {} {}", event.confidence, event.final);
  if (!event.features.empty()) content += fmt::format(" {}", fmt::join(event.features.numbers(), " "));
  for (const auto& word : event.words) content += fmt::format(" {} {}", word.text, word.t.us);
  for (const auto& other : event.alternatives) content += fmt::format(" {} {}", other.text, other.confidence);
  return content;
}

}  // namespace

bool comes_before(const Engine& engine, const EngineState& state, const InputEvent& a, const InputEvent& b) {
  const auto key = [&](const InputEvent& event) {
    return std::tuple(rank_of(engine, state, event), event.t, event.modality != Modality::speech, content_of(event));
  };
  return key(a) < key(b);
}

}  // namespace continua
