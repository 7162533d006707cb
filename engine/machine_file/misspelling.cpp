#include "continua/machine_file/misspelling.h"

#include <algorithm>
#include <cctype>

namespace continua {
namespace {

bool same_but_for_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

}  // namespace

bool is_slip(std::string_view a, std::string_view b) {
  const auto [shorter, longer] = std::minmax({a.size(), b.size()});
  if (shorter < 3 || longer - shorter > 1 || a == b) return false;
  std::size_t front = 0, back = 0;
  while (front < shorter && a[front] == b[front]) ++front;
  while (back < shorter - front && a[a.size() - 1 - back] == b[b.size() - 1 - back]) ++back;
  const auto x = a.substr(front, a.size() - front - back), y = b.substr(front, b.size() - front - back);
  const auto letters = [](std::string_view part) {
    return std::all_of(part.begin(), part.end(), [](unsigned char c) { return std::isalpha(c); });
  };
  if (!letters(x) || !letters(y)) return false;
  const bool exchanged = x.size() == 2 && y.size() == 2 && x[0] == y[1] && x[1] == y[0];
  const bool one_letter = x.size() <= 1 && y.size() <= 1 && front > 0 && back > 0;
  return one_letter || exchanged || same_but_for_case(x, y);
}

}  // namespace continua
