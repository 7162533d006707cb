// Which elements of two sequences are the same ones: a common subsequence, as long as bounded work finds it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace continua {

struct Alignment {
  /// Places of common elements in both sequences, growing in both.
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  /// The search for common elements ended at these places: the rest has nothing in common, or too little. The
  /// sequences' sizes if all was searched.
  std::pair<std::size_t, std::size_t> searched;
};

/// Elements are equal where their numbers are. Between common elements, short parts are aligned best (a longest common
/// subsequence); in long ones the nearest place is taken where several elements in a row agree. Time and memory grow
/// linearly with the sequences' lengths.
Alignment align(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b);

}  // namespace continua
