// MediaPipe and ROS4HRI: gestures and speech of frames and messages.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "continua/core/characters.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/recogniser/json_values.h"
#include "continua/replay/recogniser/recogniser_output.h"

namespace continua {
namespace {

// A category seen for less time is noise; one that is lost for less time has not stopped.
constexpr double shortest_s = 0.1, longest_gap_s = 0.25;

struct Seen {
  std::string name;
  double from_s = 0, last_s = 0, confidence = 0;
  Json features;
};

// The gestures of one hand, frame by frame.
class HandFrames {
 public:
  void add(double t_s, const std::string& name, double confidence, Json features) {
    if (!seen_.empty() && seen_.back().name == name && t_s - seen_.back().last_s <= longest_gap_s) {
      seen_.back().last_s = t_s;
      seen_.back().confidence = std::max(seen_.back().confidence, confidence);
    } else {
      seen_.push_back({name, t_s, t_s, confidence, std::move(features)});
    }
  }

  // A stop comes with the last frame in which the gesture was seen.
  void put_events(const std::string& hand, std::vector<Json>& events) {
    std::erase_if(seen_, [](const Seen& one) { return one.last_s - one.from_s < shortest_s; });
    for (std::size_t i = 0; i < seen_.size(); ++i) {
      auto& one = seen_[i];
      while (i + 1 < seen_.size() && seen_[i + 1].name == one.name && seen_[i + 1].from_s - one.last_s <= longest_gap_s)
        one.last_s = seen_[i + 1].last_s, seen_.erase(seen_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      if (one.name == "none" || one.name.empty()) continue;
      Json event = {{"t", one.from_s}, {"kind", "gesture"}, {"name", one.name}};
      if (!hand.empty()) event["hand"] = hand;
      event["phase"] = "start";
      event["confidence"] = std::clamp(one.confidence, 0.0, 1.0);
      Json stop = event;
      if (!one.features.empty()) event["features"] = one.features;
      stop["phase"] = "stop";
      stop["t"] = one.last_s;
      events.push_back(std::move(event));
      events.push_back(std::move(stop));
    }
  }

 private:
  std::vector<Seen> seen_;
};

// The landmarks of a hand as seen from its wrist: its form, wherever it is.
Json form_of(const Json& landmarks) {
  Json numbers = Json::array();
  if (!landmarks.is_array() || landmarks.empty()) return numbers;
  for (const auto& point : landmarks)
    for (const char* axis : {"x", "y", "z"})
      numbers.push_back(
          std::round((number_of(point, axis).value_or(0) - number_of(landmarks[0], axis).value_or(0)) * 1e4) / 1e4);
  return numbers;
}

const Json& element(const Json& list, std::size_t i) {
  static const Json nothing;
  return list.is_array() && i < list.size() ? list[i] : nothing;
}

// Seconds of a stamp {"sec", "nanosec"}, ROS 1's {"secs", "nsecs"}, or a number.
std::optional<double> stamp_of(const Json& message) {
  const auto& stamp = member_of(member_of(message, "header"), "stamp");
  if (stamp.is_number()) return stamp.get<double>();
  for (const auto& [whole, part] : {std::pair("sec", "nanosec"), std::pair("secs", "nsecs")})
    if (const auto seconds = number_of(stamp, whole)) return *seconds + number_of(stamp, part).value_or(0) / 1e9;
  return std::nullopt;
}

}  // namespace

Result<std::vector<Json>> read_mediapipe(std::string_view text, const std::string& name) {
  const auto frames = objects_in(text, name);
  if (!frames) return frames.error();
  std::map<std::string, HandFrames> hands;
  for (const auto& [frame, line] : *frames) {
    const auto t_ms = number_of(frame, "timestamp_ms");
    const auto& gestures = member_of(frame, "gestures");
    if (!t_ms || !gestures.is_array())
      return lacks(name, line, "'timestamp_ms' and 'gestures' of a GestureRecognizer's result");
    for (std::size_t i = 0; i < gestures.size(); ++i) {
      const auto& best = element(gestures[i], 0);
      const auto hand = folded(text_of(element(element(member_of(frame, "handedness"), i), 0), "categoryName"));
      hands[hand == "left" || hand == "right" ? hand : ""].add(*t_ms / 1000, folded(text_of(best, "categoryName")),
                                                               number_of(best, "score").value_or(1),
                                                               form_of(element(member_of(frame, "worldLandmarks"), i)));
    }
  }
  std::vector<Json> events;
  for (auto& [hand, seen] : hands) seen.put_events(hand, events);
  return events;
}

Result<std::vector<Json>> read_ros4hri(std::string_view text, const std::string& name) {
  static const std::vector<std::string> gestures = {
      "other", "hands_on_face", "arms_crossed", "left_hand_raised", "right_hand_raised", "both_hands_raised", "waving"};
  const auto messages = objects_in(text, name);
  if (!messages) return messages.error();
  std::vector<Json> events;
  for (const auto& [message, line] : *messages) {
    const auto t_s = stamp_of(message);
    const bool speech = message.contains("final") || message.contains("incremental");
    const auto& number = member_of(message, "gesture");
    if (!t_s || (!speech && !number.is_number_unsigned()))
      return lacks(name, line, "a message LiveSpeech or Gesture of hri_msgs, with its header's stamp");
    if (speech) {
      const auto final = trimmed_words(text_of(message, "final")),
                 interim = trimmed_words(text_of(message, "incremental"));
      if (final.empty() && interim.empty()) continue;
      Json event = {{"t", *t_s}, {"kind", "speech"}, {"text", final.empty() ? interim : final}};
      if (final.empty())
        event["final"] = false;
      else if (const auto sure = number_of(message, "confidence"); sure && *sure > 0)
        event["confidence"] = std::clamp(*sure, 0.0, 1.0);
      events.push_back(std::move(event));
    } else if (const auto which = number.get<std::size_t>(); which < gestures.size()) {
      events.push_back({{"t", *t_s}, {"kind", "gesture"}, {"name", gestures[which]}});
    }
  }
  return events;
}

}  // namespace continua
