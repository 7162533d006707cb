#include "continua/replay/experiment/ddmin.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace continua {

Indices ddmin(std::size_t count, const std::function<bool(const Indices&)>& holds) {
  std::map<Indices, bool> known;
  const auto test = [&](const Indices& part) {
    const auto found = known.find(part);
    return found != known.end() ? found->second : known.emplace(part, holds(part)).first->second;
  };
  Indices all(count);
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (count == 0 || test({})) return {};

  std::size_t parts = 2;
  while (all.size() >= 2) {
    const auto begin_of = [&](std::size_t part) {
      return all.begin() + static_cast<std::ptrdiff_t>(all.size() * part / parts);
    };
    const auto reduce = [&](auto&& candidate_of, std::size_t then) {
      for (std::size_t part = 0; part < parts; ++part) {
        Indices candidate = candidate_of(part);
        if (!test(candidate)) continue;
        all = std::move(candidate);
        parts = then;
        return true;
      }
      return false;
    };
    if (reduce([&](std::size_t part) { return Indices(begin_of(part), begin_of(part + 1)); }, 2)) continue;
    const auto without = [&](std::size_t part) {
      Indices rest(all.begin(), begin_of(part));
      rest.insert(rest.end(), begin_of(part + 1), all.end());
      return rest;
    };
    if (reduce(without, std::max<std::size_t>(parts - 1, 2))) continue;
    if (parts == all.size()) break;
    parts = std::min(all.size(), parts * 2);
  }
  return all;
}

}  // namespace continua
