// A scene: an MJCF file with objects on a table and the avatar behind it, compiled, and set up as a trace wants it.
// An object of a scene is a body with a free joint, whose geoms' bounding box is centred on the body's origin. What a
// scene must have, and how its elements are named, is in mjcf/README.md.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/simulation/object_shape.h"
#include "continua/world/world_snapshot.h"

struct mjModel_;

namespace continua {

/// How a trace wants an object at the start, other than the scene has it.
struct ObjectOverride {
  std::string object;
  std::optional<double> x_m, y_m;  ///< of its centre, in W
  /// Of its centre; without it, it stands on the table if x or y is given. At most 2 cm from standing on the table or
  /// on what is under it, or lower than the table under it, it stands there; otherwise it falls.
  std::optional<double> z_m;
  std::optional<double> yaw;  ///< radians
  bool removed = false;       ///< not in the scene at all
};

struct SceneObject {
  std::string name;
  int body = 0;  ///< MuJoCo's id
  std::map<std::string, std::string> attributes;
  Vec3 half_extents_m = Vec3::Zero();
  std::optional<Box> interior = {};  ///< in its own frame
  ObjectShape shape = {};
  std::vector<Vec3> corners_B = {};  ///< of what it consists of
};

/// A value: copies share what never changes.
class Scene {
 public:
  const mjModel_& model() const { return *model_; }
  /// The generalised positions of the start (nq).
  const std::vector<double>& initial_qpos() const { return initial_qpos_; }
  /// In the order of the scene's bodies.
  const std::vector<SceneObject>& objects() const { return objects_; }
  const Box& table() const { return table_; }

  /// The complete MJCF, with inclusions in their place and without removed objects: what a digest is taken of.
  const std::string& text() const { return text_; }
  const std::string& path() const { return path_; }

  /// The world at time zero.
  WorldSnapshot initial_snapshot() const;

  /// For a viewer without MuJoCo:
  /// {"geoms":[{"body","type","size":[…],"rgba":[…],"pos":[…],"quat":[w,x,y,z]}…],   pose in the body's frame
  ///  "bodies":{name:[x,y,z,qw,qx,qy,qz]…}}                                            pose in W at time zero
  /// in metres, rounded to 1e-5; sizes are MuJoCo's (half lengths, radii). A geom of type `mesh` also has
  /// "mesh":{"vertices":[x,y,z,…],"faces":[a,b,c,…]}, in the geom's frame; those with which there would be more than
  /// 200,000 corners of faces have their size only.
  Json description() const;

 private:
  friend Result<Scene> load_scene(const std::string&, const std::vector<ObjectOverride>&);

  void stand(const std::vector<ObjectOverride>& overrides);

  std::shared_ptr<const mjModel_> model_;
  std::vector<double> initial_qpos_;
  std::vector<SceneObject> objects_;
  Box table_;
  std::string path_, text_;
};

/// Loads the MJCF file at `path`. Errors name the file and, where there is one, the line: the file is missing, empty or
/// not MJCF; MuJoCo does not take it; it lacks what a scene must have; an override names no object of it.
Result<Scene> load_scene(const std::string& path, const std::vector<ObjectOverride>& overrides = {});

/// The object at `pose` as decisions see it: on the grid, upright. A tipped object has the bounds of how it lies.
ObjectState observed(const SceneObject& object, const Pose& pose);

}  // namespace continua
