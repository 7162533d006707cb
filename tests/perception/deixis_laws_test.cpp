// Laws of fixations in any samples, and their distance from the target of pointing.
#include <algorithm>

#include "continua/perception/deixis.h"
#include "perception/pointing_samples.h"
#include "support/catch.h"
#include "term/law.h"

using namespace continua;

namespace {

struct Errors {
  std::vector<double> robust_m, mean_m;
  int missed = 0;
};

double share(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

// The longest fixation of many pointings, against the mean of all samples.
Errors errors_with(const Faults& faults, double lasts_s, double hz) {
  Errors errors;
  for (std::uint64_t seed = 1; seed <= 400; ++seed) {
    Random random(seed);
    const Vec3 target_W(random.uniform() - 0.5, 0.6 * random.uniform() - 0.3, 0);
    const auto events = pointing_samples([&](double) { return target_W; }, 1, 1 + lasts_s, hz, faults, random);
    const auto found = fixations_of(events);
    const auto longest = std::max_element(found.begin(), found.end(),
                                          [](const auto& a, const auto& b) { return a.samples < b.samples; });
    if (longest == found.end()) {
      ++errors.missed;
      continue;
    }
    errors.robust_m.push_back((longest->place_W - target_W).norm());
    Vec3 sum_W = Vec3::Zero();
    for (const auto& event : events) sum_W += *event.target_W;
    errors.mean_m.push_back((sum_W / static_cast<double>(events.size()) - target_W).norm());
  }
  return errors;
}

}  // namespace

TEST_CASE("fixations are near what was pointed at, whatever the tracker does") {
  struct Case {
    const char* what;
    Faults faults;
    double lasts_s, hz, most_median_m, most_m;
  };
  const Vec3 nowhere_W(2e3, -5e3, 0);
  const std::vector<Case> cases = {
      {"noise", {0.024, 0, 0, {}, 0}, 1, 30, 0.01, 0.02},
      {"spikes", {0.024, 0.05, 0, {}, 0}, 1, 30, 0.01, 0.02},
      {"flicker", {0.024, 0.05, 0.1, nowhere_W, 0}, 1, 30, 0.01, 0.025},
      {"dropouts", {0.024, 0.05, 0, {}, 0.7}, 1, 30, 0.01, 0.025},
      {"all", {0.024, 0.05, 0.1, nowhere_W, 0.7}, 1, 30, 0.012, 0.03},
      {"all, slow tracker", {0.024, 0.05, 0.2, nowhere_W, 0.7}, 1, 10, 0.02, 0.045},
      {"all, fast tracker", {0.024, 0.05, 0.1, nowhere_W, 0.7}, 1, 120, 0.008, 0.02},
      {"all, short", {0.024, 0.05, 0.1, nowhere_W, 0.7}, 0.5, 30, 0.016, 0.045},
  };
  for (const auto& [what, faults, lasts_s, hz, most_median_m, most_m] : cases) {
    const auto errors = errors_with(faults, lasts_s, hz);
    const double median_m = share(errors.robust_m, 0.5), p95_m = share(errors.robust_m, 0.95);
    INFO(what << ": median " << 1e3 * median_m << " mm, 95th percentile " << 1e3 * p95_m << " mm; mean "
              << 1e3 * share(errors.mean_m, 0.5) << " mm, " << 1e3 * share(errors.mean_m, 0.95) << " mm; missed "
              << errors.missed);
    CHECK(median_m < most_median_m);
    CHECK(p95_m < most_m);
    CHECK(errors.missed <= 2);
    if (faults.spikes > 0) CHECK(share(errors.mean_m, 0.5) > 10 * median_m);
  }
}
