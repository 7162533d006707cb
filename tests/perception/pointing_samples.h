// Pointing as trackers report it: places over time, with the faults that recordings show, from a seed.
#pragma once

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "continua/core/random.h"
#include "continua/perception/deixis.h"

namespace continua {

inline const Box around_table = {{-0.75, -0.6, 0}, {0.75, 0.6, 0}};

inline InputEvent sample_at(double t_s, double x, double y, const std::string& hand = "right") {
  InputEvent event;
  event.t = SimTime::from_seconds(t_s);
  event.modality = Modality::pointing;
  event.hand = hand;
  event.target_W = Vec3(x, y, 0);
  return event;
}

struct Faults {
  double sd_m = 0;       ///< normal noise along x and y
  double spikes = 0;     ///< share of samples thrown 0.5 m to 100 km away
  double flicker_s = 0;  ///< so long it is right, then half as long at `astray`; 0: it never is
  Vec3 astray_W = {2e3, -5e3, 0};
  double dropouts = 0;  ///< a second; each of 0.1 to 0.4 s
};

inline double normal(Random& random) {
  return std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(6.283185307179586 * random.uniform());
}

/// Samples of `where(t)` from `from_s` to `until_s`, `hz` a second.
inline std::vector<InputEvent> pointing_samples(const std::function<Vec3(double)>& where, double from_s, double until_s,
                                                double hz, const Faults& faults, Random& random,
                                                const std::string& hand = "right") {
  std::vector<InputEvent> events;
  double silent_until = from_s;
  for (double t = from_s; t <= until_s + 1e-9; t += 1 / hz) {
    if (random.uniform() < faults.dropouts / hz) silent_until = t + 0.1 + 0.3 * random.uniform();
    if (t < silent_until) continue;
    Vec3 p_W = where(t) + faults.sd_m * Vec3(normal(random), normal(random), 0);
    if (faults.flicker_s > 0 && std::fmod(t - from_s, 1.5 * faults.flicker_s) > faults.flicker_s)
      p_W = faults.astray_W + faults.sd_m * Vec3(normal(random), normal(random), 0);
    if (random.uniform() < faults.spikes) {
      const double angle = 6.283185307179586 * random.uniform();
      p_W += 0.5 * std::pow(10, 5.3 * random.uniform()) * Vec3(std::cos(angle), std::sin(angle), 0);
    }
    events.push_back(sample_at(t, p_W.x(), p_W.y(), hand));
  }
  return events;
}

inline PointingTrack track_of(const std::vector<InputEvent>& events, const Box& area = around_table) {
  PointingTrack track(area);
  for (std::size_t i = 0; i < events.size(); ++i) track.add(events[i], static_cast<int>(i) + 1);
  return track;
}

inline std::vector<Deixis> fixations_of(const std::vector<InputEvent>& events) {
  return track_of(events).fixations({0}, SimTime::from_seconds(1e6));
}

}  // namespace continua
