// Pictures of a scene, drawn off screen: MuJoCo's own drawing into memory, for bodies at given poses. Nothing is
// simulated. Frame W (mjcf/README.md), metres.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/world/geometry.h"

namespace continua {

struct ImageSize {
  int width = 0, height = 0;
  auto operator<=>(const ImageSize&) const = default;
};

/// The largest width and height that are drawn.
inline constexpr int max_image_side = 4096;

struct Image {
  ImageSize size;
  std::vector<unsigned char> rgb = {};  ///< row by row from the top, three bytes a pixel
};

/// A mark drawn into the scene: the target of somebody's pointing.
struct RenderMark {
  Vec3 to_W = Vec3::Zero();       ///< place of a disc; on top of an object there
  std::string on_body = {};       ///< name of a body to put the disc on instead
  std::optional<Vec3> from_W{};   ///< a ray from here to the disc
  bool from_hand = false;         ///< the ray begins between the avatar's fingers, if there is an avatar
  std::array<float, 3> rgb = {};  ///< 0 … 1
};

/// The scene to draw.
struct RenderScene {
  std::string mjcf;                        ///< the complete MJCF (Scene::text())
  std::string asset_directory = ".";       ///< for meshes and textures
  std::map<std::string, Pose> poses = {};  ///< bodies that start elsewhere than in the MJCF
  std::string where = {};                  ///< for errors
};

/// The camera of a picture.
struct RenderView {
  /// A camera of the scene, or a view of everything on the table with the avatar: "front" (from the human's side; also
  /// ""), "left", "right", "back", "top".
  std::string camera = {};
  /// Part of the picture's height left free below, for subtitles; ignored by a scene's own camera.
  double free_below = 0;
};

/// Draws one scene in one size. Several threads may use it; they wait for each other.
class Renderer {
 public:
  /// Errors with place scene.where: the scene does not compile, or lacks the camera. Errors without place: this machine
  /// cannot draw. REQUIRES sides of `size` from 1 to max_image_side.
  static Result<Renderer> open(const RenderScene& scene, ImageSize size, const RenderView& view = {});
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Draws bodies at `poses`, the others at their start. Unknown names are ignored.
  Image draw(const std::map<std::string, Pose>& poses, const std::vector<RenderMark>& marks = {});

 private:
  class Impl;
  explicit Renderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// The reason why this machine cannot draw; nothing if it can.
Outcome cannot_render();

}  // namespace continua
