#include "continua/perception/gaze.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "continua/perception/deixis.h"

namespace continua {
namespace {

// More looks than people make in the time in which looks count.
constexpr std::size_t most_looks = 64;

// Decisions compare saliences on this grid, so that the last bits of exp2 do not reach them.
constexpr double steps_of_salience = 1000;

SimTime end_at(const Look& look, SimTime now) {
  const SimTime latest = look.until + SimTime::from_seconds(longest_dropout_s);
  return std::min({now, latest, look.next.value_or(latest)});
}

}  // namespace

bool GazeTrack::add(const GazeSample& sample) {
  if (!looks_.empty()) {
    auto& last = looks_.back();
    if (sample.t < last.from) return false;
    if (last.object == sample.object && end_at(last, sample.t) == sample.t) {
      last.until = std::max({last.until, sample.t, sample.until});
      last.confidence += (sample.confidence - last.confidence) / ++last.samples;
      return false;
    }
    last.next = sample.t;
  }
  looks_.push_back({.object = sample.object,
                    .from = sample.t,
                    .until = std::max(sample.t, sample.until),
                    .next = std::nullopt,
                    .confidence = sample.confidence,
                    .samples = 1,
                    .serial = sample.serial});
  if (looks_.size() > most_looks) looks_.erase(looks_.begin());
  return true;
}

std::vector<Salient> GazeTrack::salient(SimTime now, double half_life_s, double least) const {
  struct Sum {
    Salient salient;
    SimTime latest;
  };
  std::vector<Sum> sums;
  for (const auto& look : looks_) {
    if (look.object.empty()) continue;
    const SimTime end = end_at(look, now);
    const double seconds = std::max(0.0, (end - look.from).seconds());
    const double salience = look.confidence * seconds * std::exp2(-(now - end).seconds() / half_life_s);
    auto known = std::find_if(sums.begin(), sums.end(), [&](const Sum& s) { return s.salient.object == look.object; });
    if (known == sums.end()) known = sums.insert(sums.end(), {{look.object, 0, {}}, look.from});
    known->salient.salience += salience;
    known->salient.serials.push_back(look.serial);
    known->latest = look.from;
  }
  for (auto& [each, latest] : sums) each.salience = std::round(each.salience * steps_of_salience) / steps_of_salience;
  std::erase_if(sums, [&](const Sum& sum) { return sum.salient.salience < least; });
  std::sort(sums.begin(), sums.end(), [](const Sum& a, const Sum& b) {
    return std::tuple(-a.salient.salience, b.latest, a.salient.object) <
           std::tuple(-b.salient.salience, a.latest, b.salient.object);
  });
  std::vector<Salient> all;
  for (auto& sum : sums) all.push_back(std::move(sum.salient));
  return all;
}

}  // namespace continua
