#include "continua/replay/mcap/ros4hri_frames.h"

#include <cmath>

#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

constexpr int deepest_frame = 100;  // frames from one of a person to the world; more are a circle

std::string without_slash(std::string frame) {
  if (frame.starts_with('/')) frame.erase(0, 1);
  return frame;
}

std::optional<Vec3> vector_in(const Json& xyz) {
  Vec3 v;
  for (int i = 0; i < 3; ++i) {
    const auto& number = member_of(xyz, std::array{"x", "y", "z"}[static_cast<std::size_t>(i)]);
    if (!number.is_number() || !std::isfinite(number.get<double>())) return std::nullopt;
    v[i] = number.get<double>();
  }
  return v;
}

bool is_wrist(const std::string& frame) { return frame.starts_with("l_wrist_") || frame.starts_with("r_wrist_"); }
bool is_gaze(const std::string& frame) { return frame.starts_with("gaze_"); }

Json ray_event(double t_s, const char* kind, const Vec3& from, const Vec3& direction) {
  const auto list = [](const Vec3& v) { return Json{v.x(), v.y(), v.z()}; };
  return {{"t", t_s}, {"kind", kind}, {"ray", {{"from", list(from)}, {"direction", list(direction)}}}};
}

}  // namespace

std::vector<Json> Ros4hriFrames::take(const Json& message, double t_s) {
  std::set<std::string> moved;
  if (const auto& transforms = member_of(message, "transforms"); transforms.is_array())
    for (const auto& transform : transforms) take_transform(transform, moved);
  std::vector<Json> events;
  for (const auto& frame : people_) {
    if (!placed(frame, moved)) continue;
    connected_.insert(frame);
    if (auto event = event_of(frame, moved, t_s)) events.push_back(*std::move(event));
  }
  return events;
}

void Ros4hriFrames::take_transform(const Json& transform, std::set<std::string>& moved) {
  const auto frame = without_slash(text_of(transform, "child_frame_id"));
  const auto parent = without_slash(text_of(member_of(transform, "header"), "frame_id"));
  const auto& told = member_of(transform, "transform");
  const auto& rotation = member_of(told, "rotation");
  const auto place = vector_in(member_of(told, "translation")), axis = vector_in(rotation);
  const auto& w = member_of(rotation, "w");
  if (frame.empty() || parent.empty() || !place || !axis || !w.is_number() || !std::isfinite(w.get<double>())) return;
  const Eigen::Quaterniond R_PC(w.get<double>(), axis->x(), axis->y(), axis->z());
  if (R_PC.norm() < 1e-9) return;
  links_[frame] = {parent, {*place, R_PC.normalized()}};
  moved.insert(frame);
  if (is_gaze(frame) || is_wrist(frame)) people_.insert(frame);
}

std::optional<Ros4hriFrames::Placed> Ros4hriFrames::placed(const std::string& frame,
                                                           const std::set<std::string>& moved) const {
  Placed placed;
  auto at = frame;
  for (int depth = 0; at != world_; ++depth) {
    const auto link = links_.find(at);
    if (link == links_.end() || depth == deepest_frame) return std::nullopt;
    placed.X_WF = link->second.X_PC * placed.X_WF;
    placed.moved = placed.moved || moved.contains(at);
    at = link->second.parent;
  }
  return placed;
}

std::optional<Json> Ros4hriFrames::event_of(const std::string& frame, const std::set<std::string>& moved,
                                            double t_s) const {
  const auto own = placed(frame, moved);
  const auto& from = own->X_WF.p_WB;
  if (is_gaze(frame)) {
    if (!own->moved) return std::nullopt;
    return ray_event(t_s, "gaze", from, own->X_WF.R_WB * Vec3::UnitZ());
  }
  auto elbow = frame;
  elbow.replace(2, 5, "elbow");
  const auto other = placed(elbow, moved);
  if (!other || !(own->moved || other->moved)) return std::nullopt;
  const Vec3 direction = from - other->X_WF.p_WB;
  if (direction.norm() < 1e-6) return std::nullopt;
  auto event = ray_event(t_s, "pointing", from, direction.normalized());
  event["hand"] = frame.starts_with('l') ? "left" : "right";
  return event;
}

std::vector<std::string> Ros4hriFrames::unconnected() const {
  std::vector<std::string> frames;
  for (const auto& frame : people_)
    if (!connected_.contains(frame)) frames.push_back(frame);
  return frames;
}

}  // namespace continua
