#include "continua/simulation/view_fit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "continua/core/angles.h"

namespace continua {
namespace {

// Degrees, as MuJoCo counts them: azimuth 90 looks along y, away from the human.
struct Side {
  const char* name;
  double azimuth, elevation;
};
constexpr std::array view_sides = {Side{"front", 90, -34}, Side{"left", 0, -25}, Side{"right", 180, -25},
                                   Side{"back", 270, -35}, Side{"top", 90, -89}};

constexpr double margin = 0.94;  // of half the picture: a thin frame of air

}  // namespace

std::vector<std::string> side_names() {
  std::vector<std::string> names;
  for (const auto& side : view_sides) names.emplace_back(side.name);
  return names;
}

std::optional<mjvCamera> camera_from(const std::string& side, const std::vector<Vec3>& points_W, double fovy,
                                     double aspect, double free_below) {
  const auto known =
      std::find_if(view_sides.begin(), view_sides.end(), [&](const Side& one) { return side == one.name; });
  if (known == view_sides.end()) return std::nullopt;
  const double a = known->azimuth * rad_per_deg, e = known->elevation * rad_per_deg;
  const Vec3 forward(std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e));
  const Vec3 right(std::sin(a), -std::cos(a), 0), up = right.cross(forward);
  const double half_height = std::tan(fovy * rad_per_deg / 2), half_width = half_height * aspect;

  Vec3 lookat = Vec3::Zero();
  for (const Vec3& point : points_W) lookat += point / static_cast<double>(points_W.size());
  double distance = 1;
  // The near points decide the distance, and the distance moves the middle: a few rounds settle both.
  constexpr int rounds = 12;  // plenty, at no cost
  for (int round = 0; round < rounds; ++round) {
    double low = 0, high = 0, left = 0, farthest_right = 0;
    for (const Vec3& point : points_W) {
      const Vec3 d = point - lookat;
      const double depth = std::max(distance + d.dot(forward), 0.1);
      low = std::min(low, d.dot(up) / depth);
      high = std::max(high, d.dot(up) / depth);
      left = std::min(left, d.dot(right) / depth);
      farthest_right = std::max(farthest_right, d.dot(right) / depth);
    }
    const double wanted_low = -(1 - 2 * free_below) * margin * half_height, wanted_high = margin * half_height;
    const double scale =
        std::max((high - low) / (wanted_high - wanted_low), (farthest_right - left) / (2 * margin * half_width));
    const double height_off = (high + low) / 2 - scale * (wanted_high + wanted_low) / 2;
    lookat += distance * (up * height_off + right * ((left + farthest_right) / 2));
    distance *= std::clamp(scale, 0.5, 2.0);
  }

  mjvCamera camera;
  mjv_defaultCamera(&camera);
  camera.type = mjCAMERA_FREE;
  camera.azimuth = known->azimuth;
  camera.elevation = known->elevation;
  camera.distance = distance;
  for (int i = 0; i < 3; ++i) camera.lookat[i] = lookat[i];
  return camera;
}

}  // namespace continua
