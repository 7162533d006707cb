#include "continua/replay/annotation/event_tiers.h"

#include <fmt/format.h>

#include "continua/replay/log/reading_time.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

std::string numbers_of(const Json& list) {
  std::string text;
  for (const auto& number : list) text += (text.empty() ? "" : ",") + compact(number);
  return text;
}

void append(std::string& text, const std::string& word) {
  if (word.empty()) return;
  if (!text.empty()) text += ' ';
  text += word;
}

// "0.1,-0.2", or "0,-0.5,0.3 0,1,-0.2" of a ray.
std::string place_of(const Json& event) {
  if (const auto& target = member_of(event, "target"); target.is_array()) return numbers_of(target);
  const auto& ray = member_of(event, "ray");
  if (!ray.is_object()) return {};
  return numbers_of(member_of(ray, "from")) + ' ' + numbers_of(member_of(ray, "direction"));
}

// The content of speech or of a gesture: its own, or the first of its alternatives.
std::string content_of(const Json& event, const char* member) {
  if (const auto own = text_of(event, member); !own.empty()) return own;
  const auto& others = member_of(event, "alternatives");
  return others.is_array() && !others.empty() ? text_of(others[0], "text") : std::string();
}

SimTime time_of(const Json& event, const char* member, SimTime otherwise) {
  const auto& value = member_of(event, member);
  return value.is_number() ? SimTime::from_seconds(value.get<double>()) : otherwise;
}

}  // namespace

std::string tier_of_event(const Json& event) {
  const auto kind = text_of(event, "kind");
  if (kind == "speech" || kind == "gesture" || kind == "pointing" || kind == "gaze") return "human " + kind;
  if (kind == "observed") return "observed " + text_of(event, "channel");
  return kind;
}

std::string label_of_event(const Json& event) {
  const auto kind = text_of(event, "kind");
  if (kind == "speech") return label_of(content_of(event, "text"));
  if (kind == "observed") return label_of(text_of(event, "content"));
  if (kind == "mark") return label_of(text_of(event, "text"));
  std::string label;
  if (kind == "gesture" || kind == "pointing" || kind == "gaze") {
    append(label, text_of(event, "hand"));
    if (kind == "gesture") append(label, content_of(event, "name"));
    append(label, text_of(event, "direction"));
    append(label, text_of(event, "phase"));
    append(label, place_of(event));
    return label_of(label);
  }
  Json members = event;
  for (const char* known : {"t", "kind", "row"}) members.erase(known);
  return members.empty() ? kind : label_of(compact(members));
}

void EventTiers::add(std::size_t n, std::size_t line, const Json& event) {
  const auto kind = text_of(event, "kind");
  const auto tier = tier_of_event(event);
  auto label = label_of_event(event);
  const auto t = time_of(event, "t", {});
  TierMaker::Stretch stretch{time_of(event, "happened", t), std::nullopt, frame_time};
  if (member_of(event, "until").is_number()) stretch.until = time_of(event, "until", t);
  if (kind == "speech" || kind == "observed" || kind == "mark") stretch.shown = reading_time(label);
  if (kind == "gesture") {
    const auto phase = text_of(event, "phase"), made = text_of(event, "hand") + ' ' + text_of(event, "name");
    if (phase == "stop" && begun_ == made) tiers_.end_last(tier, stretch.from);
    begun_ = phase == "start" && !stretch.until ? made : std::string();
    stretch.shown = gesture_time;
  }
  tiers_.add(tier, n, stretch, std::move(label), event, line);
  const auto& words = member_of(event, "words");
  for (std::size_t i = 0; words.is_array() && i < words.size(); ++i) {
    const auto from = time_of(words[i], "t", t);
    const auto end = i + 1 < words.size() ? std::optional(time_of(words[i + 1], "t", from)) : stretch.until;
    tiers_.add("human words", n, {from, end, reading_time("")}, text_of(words[i], "text"));
  }
}

}  // namespace continua
