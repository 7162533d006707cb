#include "continua/replay/pictures/run_motion.h"

#include <algorithm>

#include "continua/replay/log/kinds.h"
#include "continua/replay/scene/run_points.h"

namespace continua {
namespace {

// A log has at most 30 poses a second: across a wider gap the body stood still and moved in the end.
constexpr SimTime longest_step{50'000};

std::optional<Pose> pose_of(const Json& numbers) {
  const auto pose = pose_in(numbers);
  if (!pose) return std::nullopt;
  const auto& v = *pose;
  return Pose{{v[0], v[1], v[2]}, Eigen::Quaterniond(v[3], v[4], v[5], v[6]).normalized()};
}

}  // namespace

Result<RunMotion> RunMotion::read(const RunIndex& run) {
  const auto& header = run.header();
  if (!header) return header.error();
  RunMotion motion;
  const auto scene = header->find("scene");
  const bool has_scene = scene != header->end() && scene->is_object() && scene->value("mjcf", Json()).is_string() &&
                         scene->value("bodies", Json()).is_object();
  if (!has_scene) return Error{run.where(0), "the log carries no scene with the poses of its bodies: nothing to draw"};
  motion.mjcf_ = (*scene)["mjcf"].get<std::string>();
  for (const auto& [name, numbers] : (*scene)["bodies"].items()) {
    const auto pose = pose_of(numbers);
    if (!pose) return Error{run.where(0), "body '" + name + "' has no pose [x, y, z, qw, qx, qy, qz]"};
    motion.at_start_[name] = *pose;
  }
  for (const auto n : run.of_kind(log::Pose::kind.name)) {
    const auto record = run.record(n);
    if (!record) return record.error();
    const auto bodies = record->find("bodies");
    if (bodies == record->end() || !bodies->is_object()) return Error{run.where(n), "a pose without 'bodies'"};
    const auto t = run.entry(n).t;
    for (const auto& [name, numbers] : bodies->items()) {
      const auto pose = pose_of(numbers);
      if (!pose) return Error{run.where(n), "body '" + name + "' has no pose [x, y, z, qw, qx, qy, qz]"};
      auto& samples = motion.samples_[name];
      if (samples.empty() || samples.back().t <= t) samples.push_back({t, *pose});
    }
    motion.moved_.push_back(t);
  }
  return motion;
}

std::map<std::string, Pose> RunMotion::at(SimTime t) const {
  auto poses = at_start_;
  for (const auto& [name, samples] : samples_) {
    const auto after =
        std::upper_bound(samples.begin(), samples.end(), t, [](SimTime time, const Sample& s) { return time < s.t; });
    const auto start = at_start_.find(name);
    Sample before{SimTime{}, start == at_start_.end() ? samples.front().pose : start->second};
    if (after != samples.begin()) before = *std::prev(after);
    auto& pose = poses[name] = before.pose;
    if (after == samples.end()) continue;
    const SimTime from = std::max(before.t, after->t - longest_step);
    if (t <= from) continue;
    const double part = (t - from).seconds() / (after->t - from).seconds();
    pose.p_WB += part * (after->pose.p_WB - before.pose.p_WB);
    pose.R_WB = before.pose.R_WB.slerp(part, after->pose.R_WB);
  }
  return poses;
}

}  // namespace continua
