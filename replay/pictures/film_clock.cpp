#include "continua/replay/pictures/film_clock.h"

#include <algorithm>

namespace continua {
namespace {

constexpr SimTime longest_wait{1'500'000};          // a longer one is shortened
constexpr SimTime shortened_wait{800'000};          // to this
constexpr SimTime before{300'000}, after{500'000};  // shown around each happening

}  // namespace

FilmClock::FilmClock(std::vector<std::pair<SimTime, SimTime>> busy, SimTime end, bool real_time) {
  if (real_time) busy = {{SimTime{}, end}};
  busy.emplace_back(SimTime{}, SimTime{});
  std::sort(busy.begin(), busy.end());
  SimTime reached{};  // everything before is in a stretch
  const auto add = [&](SimTime until, SimTime film_length) {
    if (until <= reached) return;
    const double speed = (until - reached).seconds() / film_length.seconds();
    stretches_.push_back({film_end_, reached, until, speed});
    film_end_ = film_end_ + film_length;
    reached = until;
  };
  const auto wait_until = [&](SimTime from) {
    const SimTime wait = from - reached;
    if (wait > SimTime{}) add(from, wait > longest_wait ? shortened_wait : wait);
  };
  for (const auto& [from, until] : busy) {
    wait_until(std::min(std::max(from - before, SimTime{}), end));
    const SimTime shown_until = std::min(until + after, end);
    add(shown_until, shown_until - reached);
  }
  wait_until(end);
}

FilmClock::Instant FilmClock::at(SimTime film_t) const {
  if (stretches_.empty()) return {};
  const auto next = std::upper_bound(stretches_.begin(), stretches_.end(), film_t,
                                     [](SimTime t, const Stretch& stretch) { return t < stretch.film_from; });
  const auto& stretch = next == stretches_.begin() ? *next : *std::prev(next);
  const auto into = SimTime::from_seconds((film_t - stretch.film_from).seconds() * stretch.speed);
  return {std::min(stretch.from + into, stretch.until), stretch.speed > 1.01};
}

}  // namespace continua
