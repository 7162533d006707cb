// ROS4HRI (REP 155): speech, gestures, and bodies as frames of tf.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "continua/replay/log/run_brief.h"
#include "continua/replay/recogniser/json_reader.h"
#include "continua/replay/recogniser/recogniser_output.h"
#include "continua/replay/recogniser/ros4hri.h"

namespace continua {
namespace {

// Seconds of a stamp {"sec", "nanosec"}, ROS 1's {"secs", "nsecs"}, or a number, in the header or in the header that
// an IdHeader has.
std::optional<double> stamp_of(const Json& message) {
  const auto& header = member_of(message, "header");
  if (header.is_object() && header.contains("header")) return stamp_of(header);
  const auto& stamp = member_of(header, "stamp");
  if (stamp.is_number()) return stamp.get<double>();
  for (const auto& [whole, part] : {std::pair("sec", "nanosec"), std::pair("secs", "nsecs")})
    if (const auto seconds = number_of(stamp, whole)) return *seconds + number_of(stamp, part).value_or(0) / 1e9;
  return std::nullopt;
}

const std::map<std::string, std::string> arms = {{"l_", "left"}, {"r_", "right"}};  // by the prefix of their frames

// ROS 1 allowed "/base".
std::string frame_name(const std::string& name) { return name.starts_with('/') ? name.substr(1) : name; }

Pose pose_of(const Json& transform) {
  const auto &move = member_of(transform, "translation"), &turn = member_of(transform, "rotation");
  const auto of = [](const Json& object, const char* axis, double otherwise) {
    return number_of(object, axis).value_or(otherwise);
  };
  Pose pose;
  pose.p_WB = {of(move, "x", 0), of(move, "y", 0), of(move, "z", 0)};
  pose.R_WB = {of(turn, "w", 1), of(turn, "x", 0), of(turn, "y", 0), of(turn, "z", 0)};
  pose.R_WB.normalize();
  return pose;
}

class Ros4hriReader : public JsonReader {
 public:
  using JsonReader::JsonReader;

 private:
  void read_object(const Json& message, std::size_t line, Recognised& gain) override {
    if (message.contains("transforms")) return read_transforms(message["transforms"], gain);
    if (!is_ros4hri(message)) {
      gain.problems.push_back(lacks(name(), line, "a message LiveSpeech or Gesture of hri_msgs, or a TFMessage"));
      return;
    }
    if (auto event = ros4hri_event(message, stamp_of(message))) gain.events.push_back(*std::move(event));
  }

  // A message has the frames that have moved; others stay.
  void read_transforms(const Json& transforms, Recognised& gain) {
    std::map<std::string, std::optional<double>> moved;  // elbows and wrists with their times
    if (!transforms.is_array() || !camera()) return;
    for (const auto& one : transforms) {
      const auto name = frame_name(text_of(one, "child_frame_id"));
      frames_[name] = {frame_name(text_of(member_of(one, "header"), "frame_id")), pose_of(member_of(one, "transform"))};
      for (const auto& [prefix, hand] : arms)
        for (const char* part : {"elbow_", "wrist_"})
          if (const auto beginning = std::string(prefix) + part; name.starts_with(beginning))
            moved.try_emplace(std::string(prefix) + name.substr(beginning.size()), stamp_of(one));
    }
    for (const auto& [arm, t_s] : moved) put_arm(arm, t_s, gain);
  }

  // The forearm's ray, from the wrist; `arm` is its prefix and the body's name, "r_a1b2".
  void put_arm(const std::string& arm, std::optional<double> t_s, Recognised& gain) const {
    const auto prefix = arm.substr(0, 2), body = arm.substr(2);
    const auto elbow = place_of(prefix + "elbow_" + body), wrist = place_of(prefix + "wrist_" + body);
    if (!elbow || !wrist) return;
    const auto ray = ray_of(*wrist, *wrist - *elbow, *camera());
    if (!ray) return;
    Json event = Json::object();
    if (t_s) event["t"] = *t_s;
    event["kind"] = "pointing";
    event["hand"] = arms.at(prefix);
    event["ray"] = *ray;
    gain.events.push_back(std::move(event));
  }

  // The origin of a frame in the camera's frame; none if the frames do not lead there.
  std::optional<Vec3> place_of(std::string name) const {
    Vec3 place = Vec3::Zero();
    for (std::size_t step = 0; step <= frames_.size(); ++step) {
      if (name == camera()->frame) return place;
      const auto found = frames_.find(name);
      if (found == frames_.end()) return step > 0 && camera()->frame.empty() ? std::optional(place) : std::nullopt;
      place = found->second.pose.R_WB * place + found->second.pose.p_WB;
      name = found->second.parent;
    }
    return std::nullopt;  // they go round in a circle
  }

  struct Frame {
    std::string parent;
    Pose pose;  // in the parent
  };
  std::map<std::string, Frame> frames_;
};

}  // namespace

bool is_ros4hri(const Json& message) {
  return message.contains("final") || message.contains("incremental") ||
         member_of(message, "gesture").is_number_unsigned();
}

std::optional<Json> ros4hri_event(const Json& message, std::optional<double> t_s) {
  static const std::vector<std::string> gestures = {
      "other", "hands_on_face", "arms_crossed", "left_hand_raised", "right_hand_raised", "both_hands_raised", "waving"};
  Json event = Json::object();
  if (t_s) event["t"] = *t_s;
  if (const auto& number = member_of(message, "gesture"); number.is_number_unsigned()) {
    const auto which = number.get<std::size_t>();
    if (which >= gestures.size()) return std::nullopt;
    event["kind"] = "gesture";
    event["name"] = gestures[which];
    return event;
  }
  const auto final = trimmed_words(text_of(message, "final")), interim = trimmed_words(text_of(message, "incremental"));
  if (final.empty() && interim.empty()) return std::nullopt;
  event["kind"] = "speech";
  event["text"] = final.empty() ? interim : final;
  if (final.empty())
    event["final"] = false;
  else if (const auto sure = number_of(message, "confidence"); sure && *sure > 0)
    event["confidence"] = std::clamp(*sure, 0.0, 1.0);
  return event;
}

std::unique_ptr<RecogniserReader> ros4hri_reader(OutputSource source) {
  return std::make_unique<Ros4hriReader>(std::move(source));
}

}  // namespace continua
