// A scene: an MJCF file with objects on a table and the avatar behind it, compiled, with the start that a trace asks
// for. An object is a body with a free joint; the bounding box of its geoms is centred on the body's origin.
// mjcf/README.md lists the elements of a scene and their names.
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

/// An object's start as the trace asks for, in place of the scene's.
struct ObjectOverride {
  std::string object;
  std::optional<double> x_m, y_m;  ///< of its centre, in W
  /// Of its centre. Without z, an object with x or y stands on the table. An object less than 2 cm above the table or a
  /// thing, or lower than its support, stands there. Higher objects fall.
  std::optional<double> z_m;
  std::optional<double> yaw;  ///< radians
  bool removed = false;       ///< the scene is loaded without the object
};

struct SceneObject {
  std::string name;
  int body = 0;  ///< MuJoCo's id
  std::map<std::string, std::string> attributes;
  Vec3 half_extents_m = Vec3::Zero();
  std::optional<Box> interior = {};  ///< in its own frame
  ObjectShape shape = {};
  std::vector<Vec3> corners_B = {};  ///< of its parts
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

  /// The complete MJCF, with inclusions in their place and without removed objects. Digests are of this text.
  const std::string& text() const { return text_; }
  const std::string& path() const { return path_; }

  /// The world at time zero.
  WorldSnapshot initial_snapshot() const;

  /// For a viewer without MuJoCo:
  /// {"geoms":[{"body","type","size":[…],"rgba":[…],"pos":[…],"quat":[w,x,y,z]}…],   pose in the body's frame
  ///  "bodies":{name:[x,y,z,qw,qx,qy,qz]…}}                                            pose in W at time zero
  /// in metres, rounded to 1e-5; sizes are MuJoCo's (half lengths, radii). A geom of type `mesh` also has
  /// "mesh":{"vertices":[x,y,z,…],"faces":[a,b,c,…]}, in the geom's frame; meshes beyond 200,000 corners of
  /// faces in all have their size only.
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

/// A shorter step takes hours for a second; no contact outlives a longer one.
inline constexpr double least_timestep_s = 1e-5, most_timestep_s = 0.1;

/// Loads the MJCF file at `path`. Errors, with the file and the line if there is one: the file is missing, empty or not
/// MJCF; MuJoCo refuses it; its time step is none of the above; the scene lacks an element. Without a place, since only
/// the caller knows it: an override names no object of the scene.
Result<Scene> load_scene(const std::string& path, const std::vector<ObjectOverride>& overrides = {});

/// The object at `pose` as decisions see it: on the grid, upright. A tipped object has the bounding box of its pose.
ObjectState observed(const SceneObject& object, const Pose& pose);

}  // namespace continua
