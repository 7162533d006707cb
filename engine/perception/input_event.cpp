#include "continua/perception/input_event.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "continua/core/result.h"
#include "continua/core/words.h"

namespace continua {
namespace {

void append(std::string& symbol, const std::string& part) {
  if (part.empty()) return;
  symbol += ' ';
  symbol += part;
}

}  // namespace

std::string name_of(Modality modality) {
  switch (modality) {
    case Modality::speech:
      return "speech";
    case Modality::gesture:
      return "gesture";
    case Modality::pointing:
      return "pointing";
    case Modality::gaze:
      return "gaze";
  }
  return "speech";
}

std::string symbol_of(const InputEvent& event) {
  if (!event.final) return interim_symbol;
  std::string symbol = name_of(event.modality);
  switch (event.modality) {
    case Modality::speech:
      append(symbol, bare_words(event.text));
      break;
    case Modality::gesture:
      for (const auto* part : {&event.hand, &event.name, &event.direction, &event.phase}) append(symbol, *part);
      break;
    case Modality::pointing:
      append(symbol, event.hand);
      break;
    case Modality::gaze:
      break;
  }
  return symbol;
}

InputEvent event_of(std::string_view symbol) {
  static constexpr std::array<std::string_view, 2> hands = {"left", "right"};
  static constexpr std::array<std::string_view, 6> directions = {"left", "right", "front", "back", "up", "down"};
  static constexpr std::array<std::string_view, 3> phases = {"start", "stop", "stroke"};
  const auto is_one_of = [](const auto& names, std::string_view word) {
    return std::find(names.begin(), names.end(), word) != names.end();
  };
  std::vector<std::string_view> words;
  for (std::size_t at = 0; at < symbol.size();) {
    const auto end = std::min(symbol.find(' ', at), symbol.size());
    if (end > at) words.push_back(symbol.substr(at, end - at));
    at = end + 1;
  }
  InputEvent event;
  if (words.empty() || words.front() == name_of(Modality::speech)) {
    event.text = words.empty() ? "" : symbol.substr(symbol.find(' ') + 1);
    return event;
  }
  event.modality = Modality::gesture;
  for (const auto modality : {Modality::pointing, Modality::gaze})
    if (words.front() == name_of(modality)) event.modality = modality;
  words.erase(words.begin());
  if (words.size() > 1 && is_one_of(phases, words.back())) event.phase = words.back(), words.pop_back();
  if (words.size() > 1 && is_one_of(directions, words.back())) event.direction = words.back(), words.pop_back();
  const bool named = event.modality == Modality::gesture;
  if (words.size() > (named ? 1 : 0) && is_one_of(hands, words.front())) {
    event.hand = words.front();
    words.erase(words.begin());
  }
  for (const auto word : words) append(event.name, std::string(word));
  if (!event.name.empty()) event.name.erase(0, 1);
  return event;
}

namespace {

// Not a copy whose list is cleared, which would keep its memory: all the copies would take the square of it.
InputEvent without_alternatives(const InputEvent& event) {
  return {event.t,         event.modality,   event.text,     event.name,     event.hand,
          event.direction, event.phase,      event.features, event.target_W, event.ray,
          event.until,     event.confidence, event.final,    event.words,    {}};
}

}  // namespace

InputEvent alternative(const InputEvent& event, std::size_t k) {
  require(k <= event.alternatives.size(), "there is no such alternative");
  if (k == 0) return event;
  InputEvent other = without_alternatives(event);
  auto& reading = event.modality == Modality::speech ? other.text : other.name;
  reading = event.alternatives[k - 1].text;
  other.confidence = event.alternatives[k - 1].confidence;
  return other;
}

std::optional<Vec3> place_of(const InputEvent& event) {
  if (event.target_W) return event.target_W;
  if (!event.ray) return std::nullopt;
  const auto& [from_W, direction_W] = *event.ray;
  const double along = -from_W.z() / direction_W.z();
  // A level ray does not meet the plane of the table; a ray away from the table meets it behind the hand.
  if (!std::isfinite(along) || along < 0) return std::nullopt;
  Vec3 place_W = from_W + along * direction_W;
  place_W.z() = 0;
  if (!place_W.allFinite()) return std::nullopt;
  return place_W;
}

std::optional<double> distance_of(const InputEvent& event) {
  const auto place_W = place_of(event);
  if (!event.ray || !place_W) return std::nullopt;
  const double distance_m = (*place_W - event.ray->from_W).norm();
  return std::isfinite(distance_m) ? std::optional(distance_m) : std::nullopt;
}

}  // namespace continua
