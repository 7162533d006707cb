#include "continua/moves/earlier_pointing.h"

#include <algorithm>

namespace continua {
namespace {

bool contains(const std::vector<Vec3>& places, const Vec3& place) {
  return std::find(places.begin(), places.end(), place) != places.end();
}

std::size_t number_of(const EarlierPointings& earlier) {
  return earlier.things.size() +
         static_cast<std::size_t>(std::count_if(earlier.places.begin(), earlier.places.end(),
                                                [&](const Vec3& place) { return !contains(earlier.things, place); }));
}

}  // namespace

std::vector<Showing> taken_by(const std::vector<Demonstrative>& demonstratives, const EarlierPointings& earlier) {
  std::vector<Demonstrative> needing;
  std::copy_if(demonstratives.rbegin(), demonstratives.rend(), std::back_inserter(needing),
               [](const Demonstrative& each) { return each.needs; });
  if (needing.size() > number_of(earlier))
    std::stable_partition(needing.begin(), needing.end(), [](const Demonstrative& each) { return !each.place; });

  std::vector<Showing> showings;
  std::vector<Vec3> used;
  const auto take = [&](const Demonstrative& each) {
    const auto& half = each.place ? earlier.places : earlier.things;
    const auto free = std::find_if(half.begin(), half.end(), [&](const Vec3& place) { return !contains(used, place); });
    if (free == half.end()) return;
    used.push_back(*free);
    showings.push_back({each.words, *free, false});
  };
  std::for_each(needing.begin(), needing.end(), take);
  for (auto each = demonstratives.rbegin(); each != demonstratives.rend(); ++each)
    if (each->more) take(*each);
  for (const auto& each : demonstratives)
    if (!each.needs && !each.more && !earlier.things.empty())
      showings.push_back({each.words, earlier.things.front(), false});
  return showings;
}

}  // namespace continua
