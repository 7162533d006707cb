#include "continua/simulation/scene.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/format.h>

#include "continua/simulation/avatar_elements.h"
#include "continua/simulation/geom_bounds.h"
#include "continua/simulation/mujoco_model.h"
#include "continua/simulation/scene_compile.h"

namespace continua {

namespace {

constexpr const char* table_geom = "table_top";
constexpr int most_mesh_corners = 200'000;  // of faces in a scene's description: a browser draws that many

/// "type=block color=red" as pairs. A word without '=' is an attribute with the value true.
std::map<std::string, std::string> attributes_of(const mjModel& model, const std::string& object) {
  std::map<std::string, std::string> attributes;
  const int text = id_of(model, mjOBJ_TEXT, object);
  if (text < 0) return attributes;
  std::istringstream words(model.text_data + model.text_adr[text]);
  for (std::string word; words >> word;) {
    const std::size_t equals = word.find('=');
    attributes[word.substr(0, equals)] = equals == std::string::npos ? "true" : word.substr(equals + 1);
  }
  return attributes;
}

bool is_object(const mjModel& model, int body) {
  return model.body_jntnum[body] == 1 && model.jnt_type[model.body_jntadr[body]] == mjJNT_FREE;
}

/// The box site of an object's hollow, in the object's frame; nothing if the object has no hollow.
Result<std::optional<Box>> interior_of(const mjModel& model, int body, const std::string& path) {
  const std::string name = name_of(model, mjOBJ_BODY, body) + "_interior";
  const int site = id_of(model, mjOBJ_SITE, name);
  if (site < 0) return std::optional<Box>();
  const mjtNum *p = model.site_pos + 3 * site, *q = model.site_quat + 4 * site, *size = model.site_size + 3 * site;
  if (model.site_bodyid[site] != body || model.site_type[site] != mjGEOM_BOX || q[0] != 1)
    return Error{path, fmt::format("site '{}': expected a box of that body, along its axes", name)};
  const Vec3 center(p[0], p[1], p[2]), half(size[0], size[1], size[2]);
  return std::optional(Box{center - half, center + half});
}

Result<std::vector<SceneObject>> objects_of(const mjModel& model, const std::string& path) {
  std::vector<SceneObject> objects;
  for (int body = 1; body < model.nbody; ++body) {
    if (!is_object(model, body)) continue;
    if (!mj_id2name(&model, mjOBJ_BODY, body)) return Error{path, "a body with a free joint has no name"};
    const std::string name = name_of(model, mjOBJ_BODY, body);
    const Box bounds = body_bounds_B(model, body);
    if (bounds.center().norm() > position_grid_m) {
      const Vec3 c = bounds.center();
      return Error{path,
                   fmt::format("object '{}': the bounding box of its geoms is centred at ({:.4f}, {:.4f}, {:.4f}) of "
                               "its frame, expected at the origin",
                               name, c.x(), c.y(), c.z())};
    }
    const auto interior = interior_of(model, body, path);
    if (!interior) return interior.error();
    const Vec3 half_extents_m = (bounds.max - bounds.min) / 2;
    objects.push_back({name, body, attributes_of(model, name), half_extents_m, *interior,
                       ObjectShape::of_body(model, body, half_extents_m), body_corners_B(model, body)});
  }
  return objects;
}

Result<Box> table_of(const mjModel& model, const std::string& path) {
  const int geom = id_of(model, mjOBJ_GEOM, table_geom);
  if (geom < 0) return Error{path, fmt::format("the scene has no geom named '{}'", table_geom)};
  const int body = model.geom_bodyid[geom];
  const Vec3 half(model.geom_size[3 * geom], model.geom_size[3 * geom + 1], model.geom_size[3 * geom + 2]);
  const mjtNum* p = model.geom_pos + 3 * geom;
  const Vec3 center = Vec3(p[0], p[1], p[2]) +
                      Vec3(model.body_pos[3 * body], model.body_pos[3 * body + 1], model.body_pos[3 * body + 2]);
  if (model.geom_type[geom] != mjGEOM_BOX || model.body_weldid[body] != 0 || std::abs(center.z() + half.z()) > 1e-6)
    return Error{path, fmt::format("geom '{}': expected a box that does not move, its top face at z = 0", table_geom)};
  return Box{on_grid(Vec3(center.x() - half.x(), center.y() - half.y(), 0)),
             on_grid(Vec3(center.x() + half.x(), center.y() + half.y(), 0))};
}

/// Puts an object at the start of its override. Without yaw the object keeps the orientation of the scene.
void place(const mjModel& model, const SceneObject& object, const ObjectOverride& wanted, std::vector<double>& qpos) {
  double* q = qpos.data() + model.jnt_qposadr[model.body_jntadr[object.body]];
  if (wanted.x_m) q[0] = *wanted.x_m;
  if (wanted.y_m) q[1] = *wanted.y_m;
  if (wanted.x_m || wanted.y_m) q[2] = object.half_extents_m.z();
  if (wanted.z_m) q[2] = *wanted.z_m;
  if (!wanted.yaw) return;
  q[3] = std::cos(*wanted.yaw / 2);
  q[4] = q[5] = 0;
  q[6] = std::sin(*wanted.yaw / 2);
}

/// The height of the object's support: the highest thing under its centre, if the wanted bottom is only a little off.
/// Nothing if the object starts in the air or beside the table.
std::optional<double> standing_height(const ObjectState& object, const WorldSnapshot& world) {
  constexpr double off_m = 0.02;
  const double bottom_m = object.p_WO.z() - object.half_extents_m.z();
  const auto under = [&](const Box& box) {
    return object.p_WO.x() > box.min.x() && object.p_WO.x() < box.max.x() && object.p_WO.y() > box.min.y() &&
           object.p_WO.y() < box.max.y();
  };
  if (!under(world.table)) return std::nullopt;
  double height = world.table.max.z();
  for (const auto& other : world.objects) {
    const double top = other.bounds_W().max.z();
    if (other.name != object.name && under(other.bounds_W()) && top <= bottom_m + off_m) height = std::max(height, top);
  }
  return bottom_m <= height + off_m ? std::optional(height) : std::nullopt;
}

/// Puts the arm into the posture of the scene's numbers `arm_home`, if there are any.
void place_arm(const mjModel& model, std::vector<double>& qpos) {
  const int home = id_of(model, mjOBJ_NUMERIC, "arm_home");
  const auto hinges = arm_hinges(model);
  for (std::size_t i = 0; home >= 0 && i < hinges.size() && static_cast<int>(i) < model.numeric_size[home]; ++i)
    qpos[model.jnt_qposadr[hinges[i]]] = model.numeric_data[model.numeric_adr[home] + static_cast<int>(i)];
}

Pose pose_of(const double* q) { return {{q[0], q[1], q[2]}, Eigen::Quaterniond(q[3], q[4], q[5], q[6])}; }

double rounded(double value) { return std::round(value * 1e5) / 1e5 + 0.0; }

template <class T>
Json rounded_list(const T* values, int count) {
  Json list = Json::array();
  for (int i = 0; i < count; ++i) list.push_back(rounded(static_cast<double>(values[i])));
  return list;
}

// Vertices and faces of a mesh, in its geom's frame.
Json mesh_json(const mjModel& model, int mesh) {
  Json faces = Json::array();
  const int* corner = model.mesh_face + 3 * model.mesh_faceadr[mesh];
  for (int i = 0; i < 3 * model.mesh_facenum[mesh]; ++i) faces.push_back(corner[i]);
  return {{"vertices", rounded_list(model.mesh_vert + 3 * model.mesh_vertadr[mesh], 3 * model.mesh_vertnum[mesh])},
          {"faces", std::move(faces)}};
}

const char* type_text(int geom_type) {
  switch (geom_type) {
    case mjGEOM_PLANE:
      return "plane";
    case mjGEOM_SPHERE:
      return "sphere";
    case mjGEOM_CAPSULE:
      return "capsule";
    case mjGEOM_ELLIPSOID:
      return "ellipsoid";
    case mjGEOM_CYLINDER:
      return "cylinder";
    case mjGEOM_BOX:
      return "box";
    case mjGEOM_MESH:
      return "mesh";
    default:
      return "other";
  }
}

}  // namespace

Result<Scene> load_scene(const std::string& path, const std::vector<ObjectOverride>& overrides) {
  auto compiled = compile_scene(path);
  if (!compiled) return compiled.error();
  auto& [source, model, guesses] = *compiled;
  auto objects = objects_of(*model, path);
  if (!objects) return objects.error();

  // Names are checked against the whole scene, before objects are removed.
  std::vector<std::string> names;
  for (const auto& object : *objects) names.push_back(object.name);
  bool some_removed = false;
  for (const auto& wanted : overrides) {
    if (std::find(names.begin(), names.end(), wanted.object) == names.end())
      return Error{"", fmt::format("the scene {} has no object '{}'{}", path, wanted.object,
                                   did_you_mean(wanted.object, names))};
    if (!wanted.removed) continue;
    source = source.without_body(wanted.object);
    some_removed = true;
  }
  if (some_removed) {
    auto rest = compile(source);
    if (!rest) return rest.error();
    model = *rest;
    objects = objects_of(*model, path);
    if (!objects) return objects.error();
  }

  auto table = table_of(*model, path);
  if (!table) return table.error();

  Scene scene;
  scene.model_ = model;
  scene.objects_ = *objects;
  scene.table_ = *table;
  scene.path_ = path;
  scene.text_ = source.text();
  scene.initial_qpos_.assign(model->qpos0, model->qpos0 + model->nq);
  place_arm(*model, scene.initial_qpos_);
  for (const auto& wanted : overrides) {
    for (const auto& object : scene.objects_) {
      if (object.name == wanted.object) place(*model, object, wanted, scene.initial_qpos_);
    }
  }
  scene.stand(overrides);
  return scene;
}

ObjectState observed(const SceneObject& object, const Pose& pose) {
  ObjectState state{object.name, object.attributes, object.half_extents_m, on_grid(pose.p_WB), 0, object.interior};
  const Eigen::Matrix3d R_WB = pose.R_WB.toRotationMatrix();
  constexpr double steep = 0.7;     // sine of 45 degrees
  constexpr double upright = 0.98;  // cosine of 11 degrees: the object only leans a little
  // A steep x axis has no heading; then the y axis gives the yaw.
  const bool x_is_level = std::abs(R_WB(2, 0)) < steep;
  state.yaw = x_is_level ? std::atan2(R_WB(1, 0), R_WB(0, 0)) : std::atan2(-R_WB(0, 1), R_WB(1, 1));
  if (R_WB(2, 2) < upright && !object.corners_B.empty()) {
    const Eigen::Matrix3d R_YW = Eigen::AngleAxisd(-state.yaw, Vec3::UnitZ()).toRotationMatrix();
    Vec3 low = R_YW * R_WB * object.corners_B.front(), high = low;
    for (const Vec3& corner_B : object.corners_B) {
      const Vec3 corner = R_YW * R_WB * corner_B;
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
    state.half_extents_m = on_grid(Vec3((high - low) / 2));
    state.p_WO = on_grid(Vec3(pose.p_WB + R_YW.transpose() * (low + high) / 2));
    state.interior.reset();
  }
  return state;
}

void Scene::stand(const std::vector<ObjectOverride>& overrides) {
  for (const auto& wanted : overrides) {
    const WorldSnapshot world = initial_snapshot();
    const ObjectState* object = wanted.z_m ? world.find(wanted.object) : nullptr;
    const auto height = object ? standing_height(*object, world) : std::nullopt;
    if (!height) continue;
    const auto of_name = [&](const SceneObject& one) { return one.name == wanted.object; };
    const auto found = std::find_if(objects_.begin(), objects_.end(), of_name);
    double& z = initial_qpos_[static_cast<std::size_t>(model_->jnt_qposadr[model_->body_jntadr[found->body]]) + 2];
    const double standing = *height + object->half_extents_m.z();
    if (std::abs(z - standing) > position_grid_m) z = standing;
  }
}

WorldSnapshot Scene::initial_snapshot() const {
  WorldSnapshot world;
  world.table = table_;
  for (const auto& object : objects_)
    world.objects.push_back(
        observed(object, pose_of(initial_qpos_.data() + model_->jnt_qposadr[model_->body_jntadr[object.body]])));
  return world;
}

Json Scene::description() const {
  Json geoms = Json::array();
  int corners_left = most_mesh_corners;
  for (int geom = 0; geom < model_->ngeom; ++geom) {
    const int material = model_->geom_matid[geom];
    geoms.push_back(
        {{"body", name_of(*model_, mjOBJ_BODY, model_->geom_bodyid[geom])},
         {"type", type_text(model_->geom_type[geom])},
         {"size", rounded_list(model_->geom_size + 3 * geom, 3)},
         {"rgba", rounded_list(material < 0 ? model_->geom_rgba + 4 * geom : model_->mat_rgba + 4 * material, 4)},
         {"pos", rounded_list(model_->geom_pos + 3 * geom, 3)},
         {"quat", rounded_list(model_->geom_quat + 4 * geom, 4)}});
    const int mesh = model_->geom_type[geom] == mjGEOM_MESH ? model_->geom_dataid[geom] : -1;
    if (mesh < 0 || 3 * model_->mesh_facenum[mesh] > corners_left || model_->mesh_vertnum[mesh] > corners_left)
      continue;
    corners_left -= std::max(3 * model_->mesh_facenum[mesh], model_->mesh_vertnum[mesh]);
    geoms.back()["mesh"] = mesh_json(*model_, mesh);
  }

  const DataOwner data(mj_makeData(model_.get()));
  std::copy(initial_qpos_.begin(), initial_qpos_.end(), data->qpos);
  mj_kinematics(model_.get(), data.get());
  Json bodies = Json::object();
  for (int body = 0; body < model_->nbody; ++body) {
    Json pose = rounded_list(data->xpos + 3 * body, 3);
    for (int i = 0; i < 4; ++i) pose.push_back(rounded(data->xquat[4 * body + i]));
    bodies[name_of(*model_, mjOBJ_BODY, body)] = std::move(pose);
  }
  return {{"geoms", std::move(geoms)}, {"bodies", std::move(bodies)}};
}

}  // namespace continua
