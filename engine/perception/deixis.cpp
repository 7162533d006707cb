#include "continua/perception/deixis.h"

#include <algorithm>
#include <limits>
#include <tuple>

#include "continua/perception/fixations.h"

namespace continua {
namespace {

// The place, or infinity if there is none. NaN would have no order.
Vec3 place_or_nowhere(const InputEvent& event) {
  const auto place_W = place_of(event);
  return place_W && place_W->allFinite() ? *place_W : Vec3::Constant(std::numeric_limits<double>::infinity());
}

// Bounds the time that a pointing of little confidence has to last.
constexpr double least_confidence = 0.01;

auto order(const PointingSample& s) {
  return std::tie(s.t, s.hand, s.place_W.x(), s.place_W.y(), s.until, s.confidence, s.serial);
}

}  // namespace

SimTime settled_at(const Deixis& deixis) {
  if (deixis.begun) return deixis.from + SimTime::from_seconds(alone_s + (deixis.followed ? least_dwell_s : 0));
  if (deixis.gesture) return deixis.from;
  const double dwell_s = least_dwell_s / std::max(deixis.confidence, least_confidence);
  const SimTime lasted = deixis.from + SimTime::from_seconds(dwell_s);
  return lasted <= deixis.until ? lasted : deixis.until + SimTime::from_seconds(longest_dropout_s);
}

void PointingTrack::add(const InputEvent& event, int serial) {
  if (event.modality != Modality::pointing) return;
  PointingSample sample{event.t,           std::max(event.t, event.until.value_or(event.t)),
                        event.hand,        place_or_nowhere(event),
                        event.confidence,  serial,
                        distance_of(event)};
  const auto after = std::upper_bound(samples_.begin(), samples_.end(), sample,
                                      [](const auto& a, const auto& b) { return order(a) < order(b); });
  samples_.insert(after, std::move(sample));
  if (samples_.size() > most_samples) samples_.erase(samples_.begin());
}

std::vector<Deixis> PointingTrack::fixations(SimTime from, SimTime until) const {
  auto found = fixations_in(samples_, area_);
  std::erase_if(found, [&](const Deixis& each) { return each.until < from || each.from > until; });
  return found;
}

bool PointingTrack::follows(const Deixis& gesture) const {
  return std::any_of(samples_.begin(), samples_.end(), [&](const PointingSample& each) {
    return each.t > gesture.from && (each.hand == gesture.hand || each.hand.empty() || gesture.hand.empty());
  });
}

void PointingTrack::forget_before(SimTime t) {
  std::erase_if(samples_, [&](const PointingSample& each) { return each.until < t; });
}

void PointingTrack::forget(const Deixis& fixation) {
  std::erase_if(samples_, [&](const PointingSample& each) {
    const bool in_its_time = each.t >= fixation.from && each.t <= fixation.until;
    const auto& serials = fixation.serials;
    return in_its_time &&
           (each.hand == fixation.hand || std::find(serials.begin(), serials.end(), each.serial) != serials.end());
  });
}

bool is_part_of(const Deixis& fixation, const Deixis& gesture) {
  const bool is_one_hand = gesture.hand == fixation.hand || gesture.hand.empty() || fixation.hand.empty();
  const SimTime until = gesture.until + SimTime::from_seconds(gesture.begun ? alone_s : 0);
  return is_one_hand && fixation.from <= until && gesture.from <= fixation.until;
}

Deixis with_dwell(Deixis gesture, const std::vector<Deixis>& fixations) {
  if (!gesture.begun) return gesture;
  const auto longer = [&](const Deixis& a, const Deixis& b) { return a.samples < b.samples; };
  std::vector<Deixis> parts;
  for (const auto& fixation : fixations)
    if (fixation.samples > 1 && is_part_of(fixation, gesture)) parts.push_back(fixation);
  const auto dwell = std::max_element(parts.begin(), parts.end(), longer);
  if (dwell == parts.end()) return gesture;
  gesture.until = std::max(gesture.until, dwell->until);
  gesture.place_W = dwell->place_W;
  gesture.spread_m = dwell->spread_m;
  gesture.confidence = dwell->confidence;
  gesture.left_out = dwell->left_out;
  gesture.samples = dwell->samples;
  gesture.serials.insert(gesture.serials.end(), dwell->serials.begin(), dwell->serials.end());
  return gesture;
}

std::optional<Deixis> deixis_of(const InputEvent& event, int serial) {
  if (event.modality != Modality::gesture || event.phase == "stop" || !event.target_W || !event.target_W->allFinite())
    return std::nullopt;
  Deixis deixis;
  deixis.from = event.t;
  deixis.until = std::max(event.t, event.until.value_or(event.t));
  deixis.hand = event.hand;
  deixis.place_W = *event.target_W;
  deixis.distance_m = distance_of(event);
  deixis.gesture = true;
  deixis.begun = event.phase == "start" && !event.until;
  deixis.confidence = event.confidence;
  deixis.samples = 1;
  deixis.serials = {serial};
  return deixis;
}

}  // namespace continua
