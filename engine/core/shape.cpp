#include "continua/core/shape.h"

#include <algorithm>
#include <cmath>

#include "continua/core/result.h"

namespace continua {
namespace {

constexpr double distance_grid = 1e-6;

double largest(const Shape& shape) {
  double most = 0;
  for (const double number : shape.numbers()) most = std::max(most, std::abs(number));
  return most;
}

}  // namespace

bool Shape::operator==(const Shape& other) const {
  if (empty() || other.empty()) return empty() == other.empty();
  return numbers() == other.numbers();
}

double distance(const Shape& a, const Shape& b) {
  require(!a.empty() && a.size() == b.size(), "shapes of different sizes have no distance");
  // Numbers are divided by the largest first, so that no square is infinite.
  const double scale = std::max(largest(a), largest(b));
  if (scale == 0) return 0;
  double apart = 0, of_a = 0, of_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double x = a.numbers()[i] / scale, y = b.numbers()[i] / scale;
    apart += (x - y) * (x - y);
    of_a += x * x;
    of_b += y * y;
  }
  return std::round(std::sqrt(apart / std::max(of_a, of_b)) / distance_grid) * distance_grid;
}

}  // namespace continua
