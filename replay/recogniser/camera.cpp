#include "continua/replay/recogniser/camera.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "continua/core/read_document.h"
#include "continua/core/replaced_file.h"

namespace continua {
namespace {

constexpr double most_m = 1000, most_px = 100000, least_angle_rad = 0.01, most_angle_rad = 3.1;
constexpr double most_pictures = 10;  // a corner may be so far outside of the picture
constexpr double least_area = 1e-6;   // of a triangle that is none

double rounded(double number) { return std::round(number * 1e4) / 1e4 + 0.0; }

Vec3 read_point(const Item& item) {
  const auto elements = item.elements("a point [x, y, z], in metres");
  if (item.exists() && elements.size() != 3) item.problem("expected a point [x, y, z], in metres");
  Vec3 point = Vec3::Zero();
  for (std::size_t i = 0; i < std::min<std::size_t>(elements.size(), 3); ++i)
    point[static_cast<Eigen::Index>(i)] = elements[i].number("metres", 0, -most_m, most_m);
  return point;
}

// Numbers of a point with two, and 1: a point of a projective plane.
Vec3 read_plane_point(const Item& item, double least, double most) {
  const auto numbers = item.elements("a point, [number, number]");
  if (item.exists() && numbers.size() != 2) item.problem("expected a point, [number, number]");
  Vec3 point(0, 0, 1);
  for (std::size_t i = 0; i < std::min<std::size_t>(numbers.size(), 2); ++i)
    point[static_cast<Eigen::Index>(i)] = numbers[i].number("a number", 0, least, most);
  return point;
}

// The matrix by which the unit vectors and (1, 1, 1) become multiples of the four points. None: three are in a line.
std::optional<Eigen::Matrix3d> plane_through(const std::array<Vec3, 4>& points) {
  Eigen::Matrix3d columns;
  columns << points[0], points[1], points[2];
  if (std::abs(columns.determinant()) < least_area) return std::nullopt;
  const Vec3 weights = columns.inverse() * points[3];
  if (weights.cwiseAbs().minCoeff() < least_area) return std::nullopt;
  return columns * weights.asDiagonal();
}

void read_corners(const Item& corners, Camera& camera) {
  const auto four = corners.elements("four corners");
  if (four.size() != 4) {
    corners.problem(fmt::format("found {} corners; expected four", four.size()));
    return;
  }
  std::array<Vec3, 4> seen, table;
  for (std::size_t i = 0; i < 4; ++i) {
    if (!four[i].expect_object("a corner", {"seen", "is"})) return;
    seen[i] = read_plane_point(four[i].required("seen", "a point of the picture"), -most_pictures, most_pictures);
    table[i] = read_plane_point(four[i].required("is", "a point of the table"), -most_m, most_m);
  }
  const auto of_picture = plane_through(seen), of_table = plane_through(table);
  if (!of_picture || !of_table) {
    corners.problem("three of the points are in a line; expected corners of a quadrangle");
    return;
  }
  const Eigen::Matrix3d map = *of_table * of_picture->inverse();
  camera.table_of_picture = map / (map * seen[0]).z();
}

Camera camera_of(const Item& root) {
  Camera camera;
  if (const auto corners = root.member("corners"); corners.exists()) {
    if (!root.expect_object("a camera that knows corners", {"about", "corners", "mirrored"})) return camera;
    read_corners(corners, camera);
    camera.mirrored = root.member("mirrored").truth(false);
    return camera;
  }
  if (!root.expect_object("a camera", {"about", "position", "looks_at", "size", "field_of_view", "mirrored", "frame"}))
    return camera;
  camera.X_WC.p_WB = read_point(root.required("position", "where the camera is, [x, y, z]"));
  const auto looks_at = root.required("looks_at", "the point in the middle of its picture, [x, y, z]");
  const Vec3 forward = read_point(looks_at) - camera.X_WC.p_WB;
  // Level pictures: x is at right angles to W's z. A camera that looks straight down has W's x to its right.
  const Vec3 level = forward.cross(Vec3::UnitZ());
  const Vec3 right = level.norm() > 1e-9 * forward.norm() ? Vec3(level.normalized()) : Vec3(Vec3::UnitX());
  if (forward.norm() < 1e-6) {
    looks_at.problem("expected another point than that of 'position'");
    return camera;
  }
  Eigen::Matrix3d R_WC;
  R_WC << right, forward.normalized().cross(right), forward.normalized();
  camera.X_WC.R_WB = R_WC;
  if (const auto size = root.member("size"); size.exists()) {
    const auto sides = size.elements("the picture's [width, height], in pixels");
    if (sides.size() != 2) size.problem("expected the picture's [width, height], in pixels");
    if (!sides.empty()) camera.width_px = sides[0].number("pixels", camera.width_px, 1, most_px);
    if (sides.size() > 1) camera.height_px = sides[1].number("pixels", camera.height_px, 1, most_px);
  }
  camera.field_of_view_rad =
      root.required("field_of_view", "its horizontal angle, in radians")
          .number("an angle in radians", camera.field_of_view_rad, least_angle_rad, most_angle_rad);
  camera.mirrored = root.member("mirrored").truth(false);
  if (const auto frame = root.member("frame"); frame.exists()) camera.frame = frame.name("the name of a frame");
  return camera;
}

}  // namespace

Result<Camera> read_camera(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return text.error();
  return camera_of_text(*text, path);
}

Result<Camera> camera_of_text(std::string_view text, const std::string& path) {
  return parsed_document(text, path, camera_of);
}

Result<std::shared_ptr<const Camera>> named_camera(const std::string& path) {
  if (path.empty()) return std::shared_ptr<const Camera>();
  const auto camera = read_camera(path);
  if (!camera) return camera.error();
  return std::make_shared<const Camera>(*camera);
}

std::optional<Vec3> origin_of(const std::vector<SeenPoint>& points, const Camera& camera) {
  // A point p + t appears at u = (p.x + t.x) / (p.z + t.z), so t.x - u t.z = u p.z - p.x; down likewise.
  const double half_width = std::tan(camera.field_of_view_rad / 2);
  const double half_height = half_width * camera.height_px / camera.width_px;
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Vec3 b = Vec3::Zero();
  const auto add = [&](const Vec3& row, double value) {
    A += row * row.transpose();
    b += row * value;
  };
  for (const auto& point : points) {
    const double u = (2 * point.across - 1) * half_width, v = (2 * point.down - 1) * half_height;
    add({1, 0, -u}, u * point.p_C.z() - point.p_C.x());
    add({0, 1, -v}, v * point.p_C.z() - point.p_C.y());
  }
  if (points.size() < 2 || std::abs(A.determinant()) < 1e-12) return std::nullopt;
  const Vec3 origin = A.inverse() * b;
  return origin.allFinite() && origin.z() > 0 ? std::optional(origin) : std::nullopt;
}

std::optional<Json> target_of(double across, double down, const Camera& camera) {
  if (!camera.table_of_picture) return std::nullopt;
  const Vec3 point = *camera.table_of_picture * Vec3(across, down, 1);
  if (point.z() < 1e-6) return std::nullopt;
  return Json{rounded(point.x() / point.z()), rounded(point.y() / point.z())};
}

std::optional<Json> ray_of(const Vec3& from_C, const Vec3& direction_C, const Camera& camera) {
  if (direction_C.norm() < 1e-6) return std::nullopt;
  const auto numbers = [](const Vec3& point) {
    return Json{rounded(point.x()), rounded(point.y()), rounded(point.z())};
  };
  return Json{{"from", numbers(camera.X_WC.R_WB * from_C + camera.X_WC.p_WB)},
              {"direction", numbers(camera.X_WC.R_WB * direction_C.normalized())}};
}

}  // namespace continua
