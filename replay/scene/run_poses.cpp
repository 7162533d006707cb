#include "continua/replay/scene/run_poses.h"

#include <algorithm>

#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

constexpr std::size_t most_bodies = 10000;
constexpr std::size_t shortest_stride = 256, most_keyframes = 512;

// A name as it stands in the log, with its quotes, as the text that it means.
std::string name_in(std::string_view quoted) {
  if (quoted.find('\\') == std::string_view::npos) return std::string(quoted);
  const auto json = Json::parse("\"" + std::string(quoted) + "\"", nullptr, false);
  return json.is_string() ? json.get<std::string>() : std::string(quoted);
}

}  // namespace

RunPoses::RunPoses(std::shared_ptr<const RunIndex> run) : run_(std::move(run)) {
  if (const auto& header = run_->header()) {
    const auto& bodies = member_of(member_of(*header, "scene"), "bodies");
    if (bodies.is_object())
      for (const auto& [name, numbers] : bodies.items())
        if (const auto pose = pose_in(numbers); pose && at_start_.size() < most_bodies) at_start_.emplace(name, *pose);
  }
  for (const auto n : run_->of_kind(log::Pose::kind.name)) {
    records_.push_back(static_cast<std::uint32_t>(n));
    const auto t = run_->entry(n).t;
    times_.push_back(times_.empty() ? t : std::max(times_.back(), t));
  }
  stride_ = std::max(shortest_stride, records_.size() / most_keyframes + 1);
  keyframes_.emplace_back();
}

// Takes down which bodies the record tells of.
void RunPoses::note(std::size_t place, Latest& latest) {
  const auto line = run_->line(records_[place]);
  if (!line) return;
  scan_members(*line, [&](std::string_view key, std::string_view value) {
    if (key != "bodies") return;
    scan_members(value, [&](std::string_view quoted, std::string_view) {
      const auto name = name_in(quoted);
      auto known = numbers_.find(name);
      if (known == numbers_.end()) {
        if (names_.size() >= most_bodies) return;
        known = numbers_.emplace(name, static_cast<std::uint32_t>(names_.size())).first;
        names_.push_back(name);
      }
      if (latest.size() <= known->second) latest.resize(known->second + 1);
      latest[known->second] = static_cast<std::uint32_t>(place + 1);
    });
  });
}

RunPoses::Latest RunPoses::latest_before(std::size_t place) {
  const auto keyframe = place / stride_;
  while (keyframes_.size() <= keyframe) {
    const auto from = (keyframes_.size() - 1) * stride_;
    auto latest = keyframes_.back();
    for (auto i = from; i < from + stride_; ++i) note(i, latest);
    keyframes_.push_back(std::move(latest));
  }
  auto latest = keyframes_[keyframe];
  for (auto i = keyframe * stride_; i < place; ++i) note(i, latest);
  return latest;
}

std::size_t RunPoses::records_until(SimTime t) const {
  return static_cast<std::size_t>(std::upper_bound(times_.begin(), times_.end(), t) - times_.begin());
}

BodyPoses RunPoses::at(SimTime t) {
  std::map<std::uint32_t, std::vector<std::string>> told;  // bodies that a record was the last to tell of
  {
    const std::lock_guard lock(mutex_);
    const auto latest = latest_before(records_until(t));
    for (std::size_t body = 0; body < latest.size(); ++body)
      if (latest[body]) told[records_[latest[body] - 1]].push_back(names_[body]);
  }
  auto poses = at_start_;
  for (const auto& [n, names] : told) {
    const auto record = run_->record(n);
    if (!record) continue;
    for (const auto& name : names)
      if (const auto pose = pose_in(member_of(member_of(*record, "bodies"), name.c_str()))) poses[name] = *pose;
  }
  return poses;
}

RunPoses::Changes RunPoses::changes(SimTime from, SimTime to, std::size_t most) {
  Changes changes;
  const auto end = records_until(to);
  for (auto i = records_until(from); i < end; ++i) {
    const bool same_instant = !changes.list.empty() && changes.list.back().t == times_[i];
    if (!same_instant && changes.list.size() == most) {
      changes.next = changes.list.back().t;
      break;
    }
    const auto record = run_->record(records_[i]);
    const auto& bodies = record ? member_of(*record, "bodies") : Json();
    BodyPoses moved;
    if (bodies.is_object())
      for (const auto& [name, numbers] : bodies.items())
        if (const auto pose = pose_in(numbers); pose && moved.size() < most_bodies) moved.emplace(name, *pose);
    if (moved.empty()) continue;
    if (!same_instant) changes.list.push_back({times_[i], {}});
    for (const auto& [name, pose] : moved) changes.list.back().bodies[name] = pose;
  }
  return changes;
}

}  // namespace continua
