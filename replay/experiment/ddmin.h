// Delta debugging: the least of a list that still does something.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace continua {

/// Elements of a list, by index, ascending.
using Indices = std::vector<std::size_t>;

/// These elements of a list.
template <class Element>
std::vector<Element> part_of(const std::vector<Element>& all, const Indices& part) {
  std::vector<Element> some;
  for (const auto index : part) some.push_back(all[index]);
  return some;
}

/// ddmin (A. Zeller & R. Hildebrandt, Simplifying and Isolating Failure-Inducing Input, IEEE TSE 28(2), 2002, fig. 3):
/// of 0 … count-1 a part that `holds`, and that is 1-minimal: without any single one of its elements it does not hold.
/// `holds` is asked at most once for each part. REQUIRES that the whole holds; it is not asked for it.
Indices ddmin(std::size_t count, const std::function<bool(const Indices&)>& holds);

}  // namespace continua
