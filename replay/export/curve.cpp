#include "continua/replay/export/curve.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace continua {
namespace {

constexpr int samples = 32;  ///< of a piece, where its crossing is looked for
constexpr int halvings = 20;
constexpr double largest_radius = 12;

PagePoint between(const PagePoint& a, const PagePoint& b, double t) {
  return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
}

// De Casteljau: the part of the piece from `t` on.
std::array<PagePoint, 4> rest_of(const PagePoint* piece, double t) {
  const auto a = between(piece[0], piece[1], t), b = between(piece[1], piece[2], t), c = between(piece[2], piece[3], t);
  const auto d = between(a, b, t), e = between(b, c, t);
  return {between(d, e, t), e, c, piece[3]};
}

}  // namespace

double Pill::radius() const { return std::min({width / 2, height / 2, largest_radius}); }

double Pill::distance(const PagePoint& p) const {
  const double x = std::abs(p.x - centre.x) - (width / 2 - radius()),
               y = std::abs(p.y - centre.y) - (height / 2 - radius());
  return std::hypot(std::max(x, 0.0), std::max(y, 0.0)) + std::min(std::max(x, y), 0.0) - radius();
}

std::vector<PagePoint> points_along(const Curve& curve, std::size_t count) {
  if (curve.empty()) return {};
  std::vector<PagePoint> points = {curve.front()};
  for (std::size_t first = 0; first + 3 < curve.size(); first += 3)
    for (std::size_t i = 1; i <= count; ++i)
      points.push_back(rest_of(&curve[first], static_cast<double>(i) / static_cast<double>(count))[0]);
  return points;
}

Curve after_leaving(const Curve& curve, const Pill& pill, double distance) {
  for (std::size_t first = 0; first + 3 < curve.size(); first += 3) {
    const auto is_out = [&](double t) { return pill.distance(rest_of(&curve[first], t)[0]) > distance; };
    for (int i = 1; i <= samples; ++i) {
      double in = (i - 1.0) / samples, out = static_cast<double>(i) / samples;
      if (!is_out(out)) continue;
      for (int k = 0; k < halvings; ++k) (is_out((in + out) / 2) ? out : in) = (in + out) / 2;
      const auto rest = rest_of(&curve[first], out);
      Curve left(rest.begin(), rest.end());
      left.insert(left.end(), curve.begin() + static_cast<std::ptrdiff_t>(first) + 4, curve.end());
      return left;
    }
  }
  return {};
}

Curve before_entering(const Curve& curve, const Pill& pill, double distance) {
  auto left = after_leaving({curve.rbegin(), curve.rend()}, pill, distance);
  std::reverse(left.begin(), left.end());
  return left;
}

}  // namespace continua
