// MediaPipe: the gestures and the pointing of hands, frame by frame.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "continua/core/characters.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/recogniser/json_reader.h"
#include "continua/replay/recogniser/recogniser_output.h"

namespace continua {
namespace {

// A category seen for less time is noise; one that is lost for less time has not stopped.
constexpr double shortest_s = 0.1, longest_gap_s = 0.25;

// The gestures of one hand, frame by frame: a start once a gesture was seen for long enough, a stop once it is gone.
class HandFrames {
 public:
  explicit HandFrames(std::string hand) : hand_(std::move(hand)) {}

  void add(double t_s, const std::string& name, double confidence, Json features, std::vector<Json>& events) {
    pass(t_s, events);
    if (name.empty() || name == "none") return;
    if (lasting_ && lasting_->name == name) {
      lasting_->last_s = t_s;
      lasting_->confidence = std::max(lasting_->confidence, confidence);
      begun_.reset();
      return;
    }
    if (begun_ && begun_->name == name) {
      begun_->last_s = t_s;
      begun_->confidence = std::max(begun_->confidence, confidence);
    } else {
      begun_ = Seen{name, t_s, t_s, confidence, std::move(features)};
    }
    if (begun_->last_s - begun_->from_s < shortest_s) return;
    stop(events);
    lasting_ = std::exchange(begun_, std::nullopt);
    auto event = event_of(lasting_->from_s, "start");
    if (!lasting_->features.empty()) event["features"] = lasting_->features;
    events.push_back(std::move(event));
  }

  // It is `t_s` now.
  void pass(double t_s, std::vector<Json>& events) {
    if (begun_ && t_s - begun_->last_s > longest_gap_s) begun_.reset();
    if (lasting_ && t_s - lasting_->last_s > longest_gap_s) stop(events);
  }

  // Its time is that of the last frame in which the gesture was seen.
  void stop(std::vector<Json>& events) {
    if (lasting_) events.push_back(event_of(lasting_->last_s, "stop"));
    lasting_.reset();
  }

 private:
  struct Seen {
    std::string name;
    double from_s = 0, last_s = 0, confidence = 0;
    Json features;
  };

  Json event_of(double t_s, const char* phase) const {
    Json event = {{"t", t_s}, {"kind", "gesture"}, {"name", lasting_->name}};
    if (!hand_.empty()) event["hand"] = hand_;
    event["phase"] = phase;
    event["confidence"] = std::clamp(lasting_->confidence, 0.0, 1.0);
    return event;
  }

  std::string hand_;
  std::optional<Seen> begun_, lasting_;  // perhaps noise; told
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

Vec3 point_of(const Json& point) {
  return {number_of(point, "x").value_or(0), number_of(point, "y").value_or(0), number_of(point, "z").value_or(0)};
}

// The landmarks of a finger: its second joint and its tip. A finger is stretched if its tip is further from the wrist.
struct Finger {
  std::size_t joint, tip;
};
constexpr std::size_t wrist_landmark = 0, index_knuckle = 5, landmarks_of_hand = 21;
constexpr Finger index_finger = {6, 8};
constexpr Finger other_fingers[] = {{10, 12}, {14, 16}, {18, 20}};

bool is_stretched(const Finger& finger, const std::vector<SeenPoint>& points) {
  const auto from_wrist = [&](std::size_t i) { return (points[i].p_C - points[wrist_landmark].p_C).norm(); };
  return from_wrist(finger.tip) > from_wrist(finger.joint);
}

// The ray of a hand whose index finger alone is stretched: from the finger's tip, as from its knuckle.
std::optional<Json> pointing_of(const Json& picture, const Json& world, const Camera& camera) {
  if (!picture.is_array() || !world.is_array() || picture.size() != landmarks_of_hand ||
      world.size() != landmarks_of_hand)
    return std::nullopt;
  std::vector<SeenPoint> points;
  for (std::size_t i = 0; i < landmarks_of_hand; ++i) {
    const Vec3 seen = point_of(picture[i]);
    SeenPoint point = {seen.x(), seen.y(), point_of(world[i])};
    if (camera.mirrored) point.across = 1 - point.across, point.p_C.x() *= -1;
    points.push_back(point);
  }
  if (!is_stretched(index_finger, points) ||
      std::any_of(std::begin(other_fingers), std::end(other_fingers),
                  [&](const Finger& finger) { return is_stretched(finger, points); }))
    return std::nullopt;
  const auto origin = origin_of(points, camera);
  if (!origin) return std::nullopt;
  return ray_of(*origin + points[index_finger.tip].p_C, points[index_finger.tip].p_C - points[index_knuckle].p_C,
                camera);
}

class MediapipeReader : public JsonReader {
 public:
  using JsonReader::JsonReader;

  void finish(Recognised& gain) override {
    for (auto& [name, hand] : hands_) hand.stop(gain.events);
  }

 private:
  void read_object(const Json& frame, std::size_t line, Recognised& gain) override {
    const auto t_ms = number_of(frame, "timestamp_ms");
    const auto& gestures = member_of(frame, "gestures");
    if (!t_ms || !gestures.is_array()) {
      gain.problems.push_back(lacks(name(), line, "'timestamp_ms' and 'gestures' of a GestureRecognizer's result"));
      return;
    }
    const double t_s = *t_ms / 1000;
    for (auto& [name, hand] : hands_) hand.pass(t_s, gain.events);
    for (std::size_t i = 0; i < gestures.size(); ++i) read_hand(frame, i, t_s, gain);
  }

  void read_hand(const Json& frame, std::size_t i, double t_s, Recognised& gain) {
    const auto& best = element(element(member_of(frame, "gestures"), i), 0);
    const auto side = category(element(element(member_of(frame, "handedness"), i), 0));
    const std::string hand = side == "left" || side == "right" ? side : "";
    const auto& world = element(either_member(frame, "worldLandmarks", "hand_world_landmarks"), i);
    hands_.try_emplace(hand, hand)
        .first->second.add(t_s, category(best), number_of(best, "score").value_or(1), form_of(world), gain.events);
    const auto& picture = element(either_member(frame, "landmarks", "hand_landmarks"), i);
    if (auto sample = camera() ? pointing_of(picture, world, *camera()) : std::nullopt) {
      Json event = {{"t", t_s}, {"kind", "pointing"}};
      if (!hand.empty()) event["hand"] = hand;
      event["ray"] = *std::move(sample);
      gain.events.push_back(std::move(event));
    }
  }

  static std::string category(const Json& one) {
    const auto& name = either_member(one, "categoryName", "category_name");
    return name.is_string() ? folded(name.get<std::string>()) : std::string();
  }

  std::map<std::string, HandFrames> hands_;
};

}  // namespace

std::unique_ptr<RecogniserReader> mediapipe_reader(OutputSource source) {
  return std::make_unique<MediapipeReader>(std::move(source));
}

}  // namespace continua
