#include "continua/replay/diff/sequence_alignment.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <unordered_map>

namespace continua {
namespace {

using Sequence = std::span<const std::uint64_t>;
using Place = std::pair<std::size_t, std::size_t>;

// So many cells a table of a longest common subsequence may have.
constexpr std::size_t most_cells = std::size_t{1} << 20;
// So many elements in a row must agree for a place to be where the sequences meet again, and so far it is looked for.
constexpr std::size_t run = 3, window = 256;
// Farther away, as many that occur nowhere else.
constexpr std::size_t rare_run = 8;

std::size_t common_prefix(Sequence a, Sequence b) {
  return static_cast<std::size_t>(std::mismatch(a.begin(), a.end(), b.begin(), b.end()).first - a.begin());
}

std::size_t common_suffix(Sequence a, Sequence b) {
  return static_cast<std::size_t>(std::mismatch(a.rbegin(), a.rend(), b.rbegin(), b.rend()).first - a.rbegin());
}

class Aligner {
 public:
  Aligner(Sequence a, Sequence b) : a_(a), b_(b) {}

  Alignment align() {
    const auto before = common_prefix(a_, b_);
    const auto after = common_suffix(a_.subspan(before), b_.subspan(before));
    const Place from{before, before}, to{a_.size() - after, b_.size() - after};
    found_.searched = {a_.size(), b_.size()};
    add_run({0, 0}, before);
    between(from, to);
    add_run(to, after);
    return std::move(found_);
  }

 private:
  void add_run(Place from, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) found_.pairs.emplace_back(from.first + i, from.second + i);
  }

  bool small(Place from, Place to) const {
    const auto rows = to.first - from.first, columns = to.second - from.second;
    return rows == 0 || columns == 0 || rows <= most_cells / columns;
  }

  void between(Place from, Place to) {
    while (!small(from, to)) {
      const auto meeting = meeting_after(from, to);
      if (!meeting) {
        found_.searched = from;
        return;
      }
      if (small(from, *meeting)) longest(from, *meeting);
      const auto same = common_prefix(a_.subspan(meeting->first, to.first - meeting->first),
                                      b_.subspan(meeting->second, to.second - meeting->second));
      add_run(*meeting, same);
      from = {meeting->first + same, meeting->second + same};
    }
    longest(from, to);
  }

  // The table of lengths from the ends, then a walk from the beginning.
  void longest(Place from, Place to) {
    const auto rows = to.first - from.first, columns = to.second - from.second;
    if (rows == 0 || columns == 0) return;
    const auto width = columns + 1;
    lengths_.assign((rows + 1) * width, 0);
    const auto equal = [&](std::size_t i, std::size_t j) { return a_[from.first + i] == b_[from.second + j]; };
    for (std::size_t i = rows; i-- > 0;)
      for (std::size_t j = columns; j-- > 0;)
        lengths_[i * width + j] = equal(i, j) ? lengths_[(i + 1) * width + j + 1] + 1
                                              : std::max(lengths_[(i + 1) * width + j], lengths_[i * width + j + 1]);
    for (std::size_t i = 0, j = 0; i < rows && j < columns;) {
      if (equal(i, j)) {
        found_.pairs.emplace_back(from.first + i++, from.second + j++);
      } else if (lengths_[(i + 1) * width + j] >= lengths_[i * width + j + 1]) {
        ++i;
      } else {
        ++j;
      }
    }
  }

  bool agree(Place at, Place to, std::size_t count) const {
    if (to.first - at.first < count || to.second - at.second < count) return false;
    return std::equal(a_.begin() + static_cast<std::ptrdiff_t>(at.first),
                      a_.begin() + static_cast<std::ptrdiff_t>(at.first + count),
                      b_.begin() + static_cast<std::ptrdiff_t>(at.second));
  }

  std::optional<Place> meeting_after(Place from, Place to) {
    for (std::size_t skipped = 0; skipped <= window; ++skipped)
      for (std::size_t i = 0; i <= skipped; ++i) {
        const Place at{from.first + i, from.second + skipped - i};
        if (at.first <= to.first && at.second <= to.second && agree(at, to, run)) return at;
      }
    return far_meeting_after(from, to);
  }

  // Rows of elements that occur once in each sequence, by a number made of theirs.
  static std::uint64_t row_at(Sequence numbers, std::size_t at) {
    std::uint64_t mixed = 0;
    for (std::size_t i = 0; i < rare_run; ++i) mixed = (mixed ^ numbers[at + i]) * 0x9E3779B97F4A7C15ULL;
    return mixed;
  }

  void find_rare() {
    rare_ = std::unordered_map<std::uint64_t, Place>();
    constexpr auto none = std::numeric_limits<std::size_t>::max(), several = none - 1;
    const auto note = [](std::size_t& place, std::size_t at) { place = place == none ? at : several; };
    for (std::size_t i = 0; i + rare_run <= a_.size(); ++i)
      note(rare_->try_emplace(row_at(a_, i), none, none).first->second.first, i);
    for (std::size_t j = 0; j + rare_run <= b_.size(); ++j)
      if (const auto known = rare_->find(row_at(b_, j)); known != rare_->end()) note(known->second.second, j);
    std::erase_if(*rare_, [](const auto& row) { return row.second.first >= several || row.second.second >= several; });
  }

  std::optional<Place> far_meeting_after(Place from, Place to) {
    if (!rare_) find_rare();
    for (auto i = from.first; i + rare_run <= to.first; ++i) {
      const auto known = rare_->find(row_at(a_, i));
      if (known == rare_->end() || known->second.first != i) continue;
      const Place at{i, known->second.second};
      if (at.second >= from.second && agree(at, to, rare_run)) return at;
    }
    return std::nullopt;
  }

  Sequence a_, b_;
  Alignment found_;
  std::vector<std::uint32_t> lengths_;
  std::optional<std::unordered_map<std::uint64_t, Place>> rare_;
};

}  // namespace

Alignment align(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b) { return Aligner(a, b).align(); }

}  // namespace continua
