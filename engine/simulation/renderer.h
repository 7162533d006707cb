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

/// Something drawn into the scene that is no part of it: where somebody points.
struct RenderMark {
  Vec3 to_W = Vec3::Zero();       ///< a disc lies here; where an object stands, on top of it
  std::string on_body = {};       ///< if that is a body of the scene, the disc lies on top of that instead
  std::optional<Vec3> from_W{};   ///< a ray from here to the disc
  bool from_hand = false;         ///< the ray begins between the avatar's fingers, if the scene has an avatar
  std::array<float, 3> rgb = {};  ///< 0 … 1
};

/// What is drawn.
struct RenderScene {
  std::string mjcf;                        ///< the complete MJCF (Scene::text())
  std::string asset_directory = ".";       ///< where files are sought that it names
  std::map<std::string, Pose> poses = {};  ///< of bodies at the start, where other than MJCF has them
  std::string where = {};                  ///< for errors
};

/// Where pictures are taken from.
struct RenderView {
  /// A camera of the scene, or one that takes in all that is on the table and the avatar: "front" (the human's side;
  /// also
  /// ""), "left", "right", "back", "top".
  std::string camera = {};
  /// What of the picture's height is left free below, for subtitles; not with a scene's own camera.
  double free_below = 0;
};

/// Draws one scene in one size. May be used from several threads; they wait for each other.
class Renderer {
 public:
  /// `scene` is a whole one; pictures show what it holds at its start. Errors: the scene cannot be compiled, there is
  /// no such camera (placed at scene.where); pictures cannot be drawn on this machine (no place). REQUIRES sides of
  /// `size` from 1 to max_image_side.
  static Result<Renderer> open(const RenderScene& scene, ImageSize size, const RenderView& view = {});
  ~Renderer();
  Renderer(Renderer&&) noexcept;
  Renderer& operator=(Renderer&&) noexcept;

  /// Bodies stand where `poses` say, the others where they stand at the start; names of no body are passed over.
  Image draw(const std::map<std::string, Pose>& poses, const std::vector<RenderMark>& marks = {});

 private:
  class Impl;
  explicit Renderer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Why pictures cannot be drawn on this machine, or nothing if they can.
Outcome cannot_render();

}  // namespace continua
