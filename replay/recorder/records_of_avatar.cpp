#include "continua/replay/recorder/grid.h"
#include "continua/replay/recorder/record_of.h"
#include "continua/term/term_text.h"

namespace continua {
namespace {

void add_reason(const Reason& reason, log::ActResult& result) {
  if (reason.empty()) return;
  result.reason = words_of(reason);
  result.code = name_of(reason.code);
  if (!reason.objects.empty()) result.objects = reason.objects;
}

template <typename Outcome>
log::ActResult outcome_of(const Outcome& outcome) {
  log::ActResult result;
  result.position_error_m = rounded(outcome.position_error_m, pose_steps_per_metre);
  result.yaw_error = rounded(outcome.yaw_error, steps_per_radian);
  add_reason(outcome.reason, result);
  if (!outcome.touches.empty()) result.touches = outcome.touches;
  if (!outcome.moved_aside.empty()) result.moved_aside = outcome.moved_aside;
  std::vector<std::string> retries;
  for (const auto& reason : outcome.retries) retries.push_back(words_of(reason));
  if (!retries.empty()) result.retries = std::move(retries);
  return result;
}

log::PoseNumbers numbers_of(const Pose& pose) {
  log::PoseNumbers numbers;
  for (std::size_t i = 0; i < 3; ++i)
    numbers[i] = rounded(pose.p_WB[static_cast<Eigen::Index>(i)], pose_steps_per_metre);
  const auto& q = pose.R_WB;
  for (std::size_t i = 3; const double part : {q.w(), q.x(), q.y(), q.z()})
    numbers[i++] = rounded(part, quaternion_steps);
  return numbers;
}

}  // namespace

log::Utterance record_of(const Said& said, const SourceRecords& sources) {
  return {said.text, records_of(said.because, sources)};
}

log::AvatarGesture record_of(const Gestured& gestured, const SourceRecords& sources) {
  return {print(gestured.term), records_of(gestured.because, sources)};
}

log::Problem record_of(const Unplanned& unplanned) { return {std::nullopt, unplanned.reason}; }

log::ActResult result_of(const ActReport& report) { return outcome_of(report); }

log::ActResult result_of(const ActEnd& end) { return outcome_of(end); }

log::ActResult result_of(const ActStep& step) {
  log::ActResult result;
  add_reason(step.reason, result);
  return result;
}

log::Pose record_of(const PoseSample& sample) {
  log::Pose record;
  for (const auto& [name, pose] : sample.bodies) record.bodies.emplace_back(name, numbers_of(pose));
  return record;
}

log::Rest record_of(const RestSpan& span) { return {span.from.seconds(), span.to.seconds()}; }

}  // namespace continua
