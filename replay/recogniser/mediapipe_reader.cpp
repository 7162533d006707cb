// MediaPipe: the gestures and the pointing of hands, frame by frame.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "continua/core/characters.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/recogniser/hand_forms.h"
#include "continua/replay/recogniser/json_reader.h"
#include "continua/replay/recogniser/recogniser_output.h"

namespace continua {
namespace {

// A category seen for less time is noise; one that is lost for less time has not stopped. Where frames are further
// apart than that, one that two frames in a row have was there between them, unless the recogniser stood still;
// and it began and ended so much before the frame that shows it at most, lest it be told too late to count.
constexpr double shortest_s = 0.1, longest_gap_s = 0.25, longest_silence_s = 3;

// The gestures of one hand, frame by frame: a start once a gesture was seen for long enough, a stop once it is gone.
class HandFrames {
 public:
  explicit HandFrames(std::string hand) : hand_(std::move(hand)) {}

  void add(double t_s, const std::string& name, double confidence, Json features, std::vector<Json>& events) {
    if (name.empty() || name == "none") return;
    if (lasting_ && lasting_->name == name) {
      lasting_->last_s = t_s;
      lasting_->lost_s.reset();
      lasting_->confidence = std::max(lasting_->confidence, confidence);
      begun_.reset();
      return;
    }
    if (begun_ && begun_->name == name) {
      begun_->last_s = t_s;
      begun_->confidence = std::max(begun_->confidence, confidence);
    } else {
      begun_ = Seen{name, t_s, t_s, confidence, std::move(features), {}};
    }
    if (begun_->last_s - begun_->from_s < shortest_s) return;
    stop(events);
    lasting_ = std::exchange(begun_, std::nullopt);
    auto event = event_of(std::max(lasting_->from_s, t_s - longest_gap_s), "start");
    if (!lasting_->features.empty()) event["features"] = lasting_->features;
    events.push_back(std::move(event));
  }

  // It is `t_s` now.
  void pass(double t_s, std::vector<Json>& events) {
    if (begun_ && t_s - begun_->last_s > longest_gap_s) begun_.reset();
    if (!lasting_ || lasting_->last_s >= t_s) return;
    if (!lasting_->lost_s) lasting_->lost_s = t_s;
    if (t_s - lasting_->last_s > longest_gap_s) stop(events);
  }

  // Nothing that was seen goes on.
  void end(std::vector<Json>& events) {
    begun_.reset();
    stop(events);
  }

 private:
  struct Seen {
    std::string name;
    double from_s = 0, last_s = 0, confidence = 0;
    Json features;
    std::optional<double> lost_s = {};  // of the first frame without it
  };

  // Its time is that of the last frame in which the gesture was seen, or shortly before that in which it was not.
  void stop(std::vector<Json>& events) {
    if (lasting_)
      events.push_back(event_of(std::max(lasting_->last_s, lasting_->lost_s.value_or(0) - longest_gap_s), "stop"));
    lasting_.reset();
  }

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

// The landmarks of one hand; empty if they are no hand's.
HandPoints points_of(const Json& landmarks) {
  HandPoints points;
  if (landmarks.is_array() && landmarks.size() == points_of_hand)
    for (const auto& point : landmarks)
      points.emplace_back(number_of(point, "x").value_or(0), number_of(point, "y").value_or(0),
                          number_of(point, "z").value_or(0));
  return points;
}

// {"ray"} of the finger that points, from its tip, as from its knuckle; or {"target"} on the table, where its tip is
// seen.
Json pointing_of(const Finger& finger, const HandPoints& picture, const HandPoints& world, const Camera& camera) {
  if (picture.empty()) return {};
  const auto across = [&](std::size_t i) { return camera.mirrored ? 1 - picture[i].x() : picture[i].x(); };
  if (const auto target = target_of(across(finger.tip), picture[finger.tip].y(), camera)) return {{"target", *target}};
  if (camera.table_of_picture) return {};
  std::vector<SeenPoint> points;
  for (std::size_t i = 0; i < points_of_hand; ++i) {
    points.push_back({across(i), picture[i].y(), world[i]});
    if (camera.mirrored) points[i].p_C.x() *= -1;
  }
  const auto origin = origin_of(points, camera);
  if (!origin) return {};
  const auto ray =
      ray_of(*origin + points[finger.tip].p_C, points[finger.tip].p_C - points[finger.knuckle].p_C, camera);
  return ray ? Json{{"ray", *ray}} : Json();
}

class MediapipeReader : public JsonReader {
 public:
  using JsonReader::JsonReader;

  void finish(Recognised& gain) override {
    for (auto& [name, hand] : hands_) hand.end(gain.events);
  }

 private:
  void read_object(const Json& frame, std::size_t line, Recognised& gain) override {
    const auto t_ms = number_of(frame, "timestamp_ms");
    const auto& gestures = member_of(frame, "gestures");
    const auto& hands = gestures.is_array() ? gestures : world_of(frame);
    if (!t_ms || !hands.is_array()) {
      gain.problems.push_back(lacks(name(), line,
                                    "'timestamp_ms' and 'gestures' of a GestureRecognizer's result, or "
                                    "'worldLandmarks' of a HandLandmarker's"));
      return;
    }
    if (!forms_ && (!gestures.is_array() || camera())) {
      auto forms = known_forms();
      if (!forms) return gain.problems.push_back(forms.error());
      forms_ = *std::move(forms);
    }
    const double t_s = *t_ms / 1000;
    if (t_s - last_s_ > longest_silence_s) finish(gain);
    last_s_ = t_s;
    for (std::size_t i = 0; i < hands.size(); ++i) read_hand(frame, i, t_s, gain);
    pass(t_s, gain.events);
  }

  void pass(double t_s, std::vector<Json>& events) {
    for (auto& [name, hand] : hands_) hand.pass(t_s, events);
  }

  void read_hand(const Json& frame, std::size_t i, double t_s, Recognised& gain) {
    const auto& best_side = element(element(member_of(frame, "handedness"), i), 0);
    const auto side = category(best_side);
    const std::string hand = side == "left" || side == "right" ? side : "";
    const auto& world = element(world_of(frame), i);
    const auto points = points_of(world);
    const auto* form = forms_ ? forms_->find(points) : nullptr;
    const auto& gestures = member_of(frame, "gestures");
    const auto& best = gestures.is_array() ? element(element(gestures, i), 0) : best_side;
    const auto gesture = gestures.is_array() ? category(best) : form ? form->name : "";
    hands_.try_emplace(hand, hand)
        .first->second.add(t_s, gesture, number_of(best, "score").value_or(1), form_of(world), gain.events);
    if (!form || !form->pointer || !camera()) return;
    const auto& picture = element(either_member(frame, "landmarks", "hand_landmarks"), i);
    const auto sample = pointing_of(*form->pointer, points_of(picture), points, *camera());
    if (sample.empty()) return;
    Json event = {{"t", t_s}, {"kind", "pointing"}};
    if (!hand.empty()) event["hand"] = hand;
    event.update(sample);
    gain.events.push_back(std::move(event));
  }

  Result<HandForms> known_forms() const {
    if (knowledge().empty()) return Error{name(), "found no knowledge with hand_forms.json"};
    const auto path = (std::filesystem::path(knowledge()) / "hand_forms.json").string();
    const auto text = read_file(path);
    if (!text) return text.error();
    return read_hand_forms(*text, path);
  }

  static const Json& world_of(const Json& frame) {
    return either_member(frame, "worldLandmarks", "hand_world_landmarks");
  }

  static std::string category(const Json& one) {
    const auto& name = either_member(one, "categoryName", "category_name");
    return name.is_string() ? folded(name.get<std::string>()) : std::string();
  }

  std::map<std::string, HandFrames> hands_;
  std::optional<HandForms> forms_;
  double last_s_ = 0;  // of the frame before
};

}  // namespace

std::unique_ptr<RecogniserReader> mediapipe_reader(OutputSource source) {
  return std::make_unique<MediapipeReader>(std::move(source));
}

}  // namespace continua
