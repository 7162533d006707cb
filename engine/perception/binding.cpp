#include "continua/perception/binding.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>

namespace continua {
namespace {

// Costs, the most important first: needing takers without a pointing, other takers without one, distance in µs, number
// of fixations, distance of the middles in half µs.
using Cost = std::array<std::int64_t, 5>;

Cost operator+(const Cost& a, const Cost& b) {
  Cost sum;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = a[i] + b[i];
  return sum;
}

// Bounds a distance so that sums do not overflow.
std::int64_t bounded(std::int64_t us) { return std::min<std::int64_t>(us, 1'000'000'000'000); }

bool go_together(const Taker& taker, const Deixis& pointing, const FusionWindow& window) {
  return pointing.until + SimTime::from_seconds(window.before_s) >= taker.begun.value_or(taker.from) &&
         pointing.from <= taker.until + SimTime::from_seconds(window.after_s);
}

Cost cost_without(const Taker& taker) { return {taker.needs ? 1 : 0, taker.needs ? 0 : 1, 0, 0, 0}; }

Cost cost_of(const Taker& taker, const Deixis& pointing) {
  const auto middles = std::abs(taker.from.us + taker.until.us - pointing.from.us - pointing.until.us);
  return {0, 0, bounded(gap_us(taker, pointing)), pointing.gesture ? 0 : 1, bounded(middles)};
}

// The indices of the pointings in order of time.
std::vector<std::size_t> in_order(const std::vector<Deixis>& pointings) {
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < pointings.size(); ++i) order.push_back(i);
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    const Deixis &a = pointings[i], &b = pointings[j];
    return std::tie(a.from, a.until, b.gesture, a.hand, a.place_W.x(), a.place_W.y(), a.serials, i) <
           std::tie(b.from, b.until, a.gesture, b.hand, b.place_W.x(), b.place_W.y(), b.serials, j);
  });
  return order;
}

}  // namespace

std::int64_t gap_us(const Taker& taker, const Deixis& pointing) {
  return std::max({taker.from.us - pointing.until.us, pointing.from.us - taker.until.us, std::int64_t{0}});
}

std::vector<std::optional<std::size_t>> assign(const std::vector<Taker>& takers, const std::vector<Deixis>& pointings,
                                               const FusionWindow& window) {
  const auto order = in_order(pointings);
  const std::size_t n = takers.size(), m = order.size();
  // least[i][j]: the least cost of the takers from i on with the pointings from j on.
  std::vector<std::vector<Cost>> least(n + 1, std::vector<Cost>(m + 1, Cost{}));
  const auto with = [&](std::size_t i, std::size_t j) {
    return cost_of(takers[i], pointings[order[j]]) + least[i + 1][j + 1];
  };
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t j = m + 1; j-- > 0;) {
      least[i][j] = cost_without(takers[i]) + least[i + 1][j];
      if (j == m) continue;
      least[i][j] = std::min(least[i][j], least[i][j + 1]);
      if (go_together(takers[i], pointings[order[j]], window)) least[i][j] = std::min(least[i][j], with(i, j));
    }
  }
  std::vector<std::optional<std::size_t>> assigned(n);
  for (std::size_t i = 0, j = 0; i < n && j < m;) {
    if (go_together(takers[i], pointings[order[j]], window) && least[i][j] == with(i, j))
      assigned[i++] = order[j++];
    else if (least[i][j] == least[i][j + 1])
      ++j;
    else
      ++i;
  }
  return assigned;
}

}  // namespace continua
