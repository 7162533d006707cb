// The camera of a recogniser: where its pictures' points are in the world.
//
// Frame C: metres, origin in the lens, x to the right of the picture, y down, z forward; that of ROS's optical frames
// and of OpenCV. Frame W: world/geometry.h.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/world/geometry.h"

namespace continua {

/// A pinhole camera without distortion, or one of which only the place of the table in its picture is known.
/// `read_camera` describes the file.
struct Camera {
  /// From a point of the picture, (across, down, 1), to the point of the table that it shows, (x, y, 1) times a number
  /// above 0. Then the other members but `mirrored` say nothing.
  std::optional<Eigen::Matrix3d> table_of_picture;
  Pose X_WC;
  double width_px = 640, height_px = 480;
  double field_of_view_rad = 1;  ///< horizontal
  bool mirrored = false;         ///< the pictures are, as a mirror shows them
  std::string frame;             ///< its name among ROS's frames; empty: the root of a body's frames
};

/// {"position": [x, y, z], "looks_at": [x, y, z], "size": [width, height], "field_of_view": radians, "mirrored": true,
/// "frame": "NAME"}: the first two in W, required; the picture's horizontal edge is level. Errors: of the file, with
/// the place. Or {"corners": [{"seen": [across, down], "is": [x, y]}, …], "mirrored": true}: four points of the
/// picture, from 0 to 1 from its left and its top, no three of them in a line, and the points of the table that they
/// show.
Result<Camera> read_camera(const std::string& path);
Result<Camera> camera_of_text(std::string_view text, const std::string& path);

/// The camera of a file, or null for an empty path.
Result<std::shared_ptr<const Camera>> named_camera(const std::string& path);

/// A point of a hand: in the picture, from 0 to 1 from its left and its top; and in metres along the axes of C, from
/// any origin that the points of the hand share.
struct SeenPoint {
  double across = 0, down = 0;
  Vec3 p_C = Vec3::Zero();
};

/// Where the origin of the points is in C, so that they appear where they are seen: by least squares of the linear
/// equations of the projection. None: there are too few points, or the hand would be behind the lens.
std::optional<Vec3> origin_of(const std::vector<SeenPoint>& points, const Camera& camera);

/// {"from", "direction"}, a ray of a trace, from a point and a direction in C. None: the direction has no length.
std::optional<Json> ray_of(const Vec3& from_C, const Vec3& direction_C, const Camera& camera);

/// The point of the table, [x, y], that is seen at a point of the picture. None: the camera does not know the table in
/// its picture, or that point is beyond the horizon.
std::optional<Json> target_of(double across, double down, const Camera& camera);

}  // namespace continua
