#include "continua/perception/fixations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace continua {
namespace {

// DEIXIS.md has the sources of these numbers.
constexpr double reach_m = 0.1;
constexpr double recent_s = 0.3;
constexpr double smoothing_s = 0.2;
constexpr double most_dispersion_m = 0.08;
constexpr double same_place_m = 0.04;
constexpr double mad_to_sd = 1.4826;
// Bounds on the samples within these times: more than trackers send, so that many samples of one instant take bounded
// time.
constexpr std::size_t most_recent = 48, most_smoothed = 32;

using Samples = std::vector<PointingSample>;

SimTime seconds(double s) { return SimTime::from_seconds(s); }

struct Weighed {
  double value = 0, weight = 1;
};

// The value with half of the weight on either side; between two such values, their middle.
double median(std::vector<Weighed> values) {
  std::sort(values.begin(), values.end(), [](const Weighed& a, const Weighed& b) {
    return std::tie(a.value, a.weight) < std::tie(b.value, b.weight);
  });
  double total = 0;
  for (const auto& each : values) total += each.weight;
  double passed = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    passed += values[i].weight;
    if (2 * passed > total || i + 1 == values.size()) return values[i].value;
    if (2 * passed == total) return (values[i].value + values[i + 1].value) / 2;
  }
  return 0;
}

// The median place of the tracklet's samples [from, until), component by component.
Vec3 center_of(const Tracklet& tracklet, std::size_t from, std::size_t until, const Samples& samples) {
  std::vector<Weighed> x, y;
  for (auto i = from; i < until; ++i) {
    const auto& sample = samples[tracklet[i]];
    x.push_back({sample.place_W.x(), sample.confidence});
    y.push_back({sample.place_W.y(), sample.confidence});
  }
  return {median(std::move(x)), median(std::move(y)), 0};
}

Vec3 center_of(const Tracklet& tracklet, const Samples& samples) {
  return center_of(tracklet, 0, tracklet.size(), samples);
}

double distance(const Vec3& a, const Vec3& b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

SimTime begin_of(const Tracklet& tracklet, const Samples& samples) { return samples[tracklet.front()].t; }

SimTime end_of(const Tracklet& tracklet, const Samples& samples) {
  SimTime end = begin_of(tracklet, samples);
  for (const auto i : tracklet) end = std::max(end, samples[i].until);
  return end;
}

double mean_confidence(const Tracklet& tracklet, const Samples& samples) {
  double sum = 0;
  for (const auto i : tracklet) sum += samples[i].confidence;
  return sum / static_cast<double>(tracklet.size());
}

// Whether the hand stayed long enough: a sample of half the confidence counts for half of its time.
bool lasts(const Tracklet& tracklet, const Samples& samples) {
  const double length_s = (end_of(tracklet, samples) - begin_of(tracklet, samples)).seconds();
  return seconds(length_s * mean_confidence(tracklet, samples)) >= seconds(least_dwell_s);
}

// A tracklet under construction.
struct Growing {
  Tracklet members;
  SimTime end;
  Vec3 recent_W;
};

void grow(Growing& tracklet, std::size_t index, const Samples& samples) {
  tracklet.members.push_back(index);
  tracklet.end = std::max(tracklet.end, samples[index].until);
  const std::size_t size = tracklet.members.size();
  std::size_t from = size - 1;
  while (from > 0 && size - from < most_recent &&
         samples[tracklet.members[from - 1]].t + seconds(recent_s) >= samples[index].t)
    --from;
  tracklet.recent_W = center_of(tracklet.members, from, size, samples);
}

// The places of a tracklet's samples, smoothed by medians.
std::vector<Vec3> smoothed(const Tracklet& tracklet, const Samples& samples) {
  std::vector<Vec3> places;
  std::size_t from = 0, until = 0;
  for (std::size_t k = 0; k < tracklet.size(); ++k) {
    const SimTime t = samples[tracklet[k]].t;
    while (samples[tracklet[from]].t + seconds(smoothing_s) < t || from + most_smoothed < k) ++from;
    while (until < tracklet.size() && samples[tracklet[until]].t <= t + seconds(smoothing_s)) ++until;
    places.push_back(center_of(tracklet, from, std::min(until, k + most_smoothed), samples));
  }
  return places;
}

// The end of the stay that begins at `from`: the first index at which the places since `from` exceed the dispersion.
std::size_t end_of_stay(const std::vector<Vec3>& places, std::size_t from) {
  Vec3 low = places[from], high = places[from];
  for (auto i = from; i < places.size(); ++i) {
    low = low.cwiseMin(places[i]);
    high = high.cwiseMax(places[i]);
    if ((high - low).maxCoeff() > most_dispersion_m) return i;
  }
  return places.size();
}

// Whether no believable sample of another place is near in time. Then the hand is not on its way from or to one.
bool is_alone(const Tracklet& tracklet, const Samples& samples, const std::vector<bool>& believed,
              const std::string& hand) {
  const SimTime from = begin_of(tracklet, samples) - seconds(alone_s);
  const SimTime until = end_of(tracklet, samples) + seconds(alone_s);
  auto own = tracklet.begin();
  for (std::size_t i = 0; i < samples.size() && samples[i].t <= until; ++i) {
    if (own != tracklet.end() && *own == i)
      ++own;
    else if (believed[i] && samples[i].hand == hand && samples[i].until >= from)
      return false;
  }
  return true;
}

// The hand of most samples, each counted with its confidence.
std::string hand_of(const Tracklet& tracklet, const Samples& samples) {
  std::map<std::string, double> weights;
  for (const auto i : tracklet) weights[samples[i].hand] += samples[i].confidence;
  return std::max_element(weights.begin(), weights.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

Deixis deixis_of(const Tracklet& stay, const Samples& samples) {
  Deixis deixis;
  deixis.from = begin_of(stay, samples);
  deixis.until = end_of(stay, samples);
  deixis.hand = hand_of(stay, samples);
  deixis.place_W = center_of(stay, samples);
  std::vector<Weighed> x, y, distances;
  for (const auto i : stay) {
    x.push_back({std::abs(samples[i].place_W.x() - deixis.place_W.x()), samples[i].confidence});
    y.push_back({std::abs(samples[i].place_W.y() - deixis.place_W.y()), samples[i].confidence});
    if (samples[i].distance_m) distances.push_back({*samples[i].distance_m, samples[i].confidence});
    deixis.serials.push_back(samples[i].serial);
  }
  deixis.spread_m = mad_to_sd * std::max(median(std::move(x)), median(std::move(y)));
  if (!distances.empty()) deixis.distance_m = median(std::move(distances));
  deixis.samples = static_cast<int>(stay.size());
  deixis.confidence = mean_confidence(stay, samples);
  auto own = stay.begin();
  for (auto i = stay.front(); i < samples.size() && samples[i].t <= deixis.until; ++i) {
    if (own != stay.end() && *own == i)
      ++own;
    else if (samples[i].hand == deixis.hand)
      ++deixis.left_out;
  }
  return deixis;
}

bool overlap(const Deixis& a, const Deixis& b) { return a.from <= b.until && b.from <= a.until; }

double weight_of(const Deixis& fixation) { return fixation.samples * fixation.confidence; }

// Removes overlaps: a hand is at one place, so of its overlapping fixations the one with more samples stays, each
// counted with its confidence.
std::vector<Deixis> one_at_a_time(std::vector<Deixis> fixations) {
  std::sort(fixations.begin(), fixations.end(), [](const Deixis& a, const Deixis& b) {
    return std::tuple(-weight_of(a), a.from - a.until, a.from, a.hand, a.place_W.x(), a.place_W.y()) <
           std::tuple(-weight_of(b), b.from - b.until, b.from, b.hand, b.place_W.x(), b.place_W.y());
  });
  std::vector<Deixis> kept;
  for (auto& each : fixations)
    if (std::none_of(kept.begin(), kept.end(),
                     [&](const Deixis& other) { return other.hand == each.hand && overlap(each, other); }))
      kept.push_back(std::move(each));
  return kept;
}

}  // namespace

bool is_believable(const PointingSample& sample, const Box& area) {
  const auto& p_W = sample.place_W;
  return p_W.x() >= area.min.x() && p_W.x() <= area.max.x() && p_W.y() >= area.min.y() && p_W.y() <= area.max.y();
}

std::vector<Tracklet> tracklets_of(const Samples& samples, const Box& area) {
  std::vector<Growing> all;
  std::vector<std::size_t> growing;  // indices in `all` of tracklets that may still grow
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (!is_believable(samples[i], area)) continue;
    std::erase_if(growing, [&](std::size_t t) { return all[t].end + seconds(longest_dropout_s) < samples[i].t; });
    std::optional<std::size_t> nearest;
    double least = reach_m;
    for (const auto t : growing) {
      const double away = distance(all[t].recent_W, samples[i].place_W);
      if (away <= least && (!nearest || away < least)) nearest = t, least = away;
    }
    if (!nearest) {
      nearest = all.size();
      growing.push_back(*nearest);
      all.push_back({{}, samples[i].until, samples[i].place_W});
    }
    grow(all[*nearest], i, samples);
  }
  std::vector<Tracklet> tracklets;
  for (auto& each : all) tracklets.push_back(std::move(each.members));
  return tracklets;
}

std::vector<Tracklet> stays_of(const Tracklet& tracklet, const Samples& samples) {
  const auto places = smoothed(tracklet, samples);
  std::vector<Tracklet> stays;
  for (std::size_t from = 0; from < tracklet.size();) {
    const auto end = end_of_stay(places, from);
    Tracklet stay(tracklet.begin() + static_cast<std::ptrdiff_t>(from),
                  tracklet.begin() + static_cast<std::ptrdiff_t>(end));
    const bool whole = stay.size() == tracklet.size();
    if (!lasts(stay, samples) && !whole) {
      ++from;
      continue;
    }
    const bool goes_on = !stays.empty() && stays.back().back() == tracklet[from - 1] &&
                         distance(center_of(stays.back(), samples), center_of(stay, samples)) <= same_place_m;
    if (goes_on)
      stays.back().insert(stays.back().end(), stay.begin(), stay.end());
    else
      stays.push_back(std::move(stay));
    from = end;
  }
  return stays;
}

std::vector<Deixis> fixations_in(const Samples& samples, const Box& area) {
  std::vector<bool> believed;
  for (const auto& each : samples) believed.push_back(is_believable(each, area));
  std::vector<Deixis> found;
  for (const auto& tracklet : tracklets_of(samples, area))
    for (const auto& stay : stays_of(tracklet, samples)) {
      auto deixis = deixis_of(stay, samples);
      if (lasts(stay, samples) || is_alone(stay, samples, believed, deixis.hand)) found.push_back(std::move(deixis));
    }
  found = one_at_a_time(std::move(found));
  std::sort(found.begin(), found.end(), [](const Deixis& a, const Deixis& b) {
    return std::tuple(a.from, a.until, a.hand, a.place_W.x(), a.place_W.y()) <
           std::tuple(b.from, b.until, b.hand, b.place_W.x(), b.place_W.y());
  });
  return found;
}

}  // namespace continua
