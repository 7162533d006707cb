#include "continua/replay/mcap/scene_messages.h"

#include <algorithm>
#include <map>

#include "continua/replay/log/run_brief.h"
#include "continua/world/geometry.h"

namespace continua {
namespace {

constexpr const char* world = "world";
constexpr double plane_thickness_m = 0.001, endless_m = 20;  // MuJoCo's planes of size 0 are endless

Json vector_of(double x, double y, double z) { return {{"x", x}, {"y", y}, {"z", z}}; }
Json vector_of(const Vec3& v) { return vector_of(v.x(), v.y(), v.z()); }

Json quaternion_of(double w, double x, double y, double z) { return {{"x", x}, {"y", y}, {"z", z}, {"w", w}}; }

// A geom of run_scene().
struct Geom {
  explicit Geom(const Json& geom)
      : type(text_of(geom, "type")),
        size(geom["size"][0], geom["size"][1], geom["size"][2]),
        place(geom["pos"][0], geom["pos"][1], geom["pos"][2]),
        rotation(geom["quat"][0].get<double>(), geom["quat"][1].get<double>(), geom["quat"][2].get<double>(),
                 geom["quat"][3].get<double>()),
        rgba(geom["rgba"]) {}

  Json solid(const Vec3& of_size, const Vec3& at) const {
    return {{"pose",
             {{"position", vector_of(at)},
              {"orientation", quaternion_of(rotation.w(), rotation.x(), rotation.y(), rotation.z())}}},
            {"size", vector_of(of_size)},
            {"color", color()}};
  }
  Json solid(const Vec3& of_size) const { return solid(of_size, place); }
  Json color() const { return {{"r", rgba[0]}, {"g", rgba[1]}, {"b", rgba[2]}, {"a", rgba[3]}}; }

  std::string type;
  Vec3 size;  // half lengths
  Vec3 place;
  Eigen::Quaterniond rotation;
  Json rgba;
};

Json cylinder_of(const Geom& geom) {
  auto cylinder = geom.solid({2 * geom.size.x(), 2 * geom.size.x(), 2 * geom.size.y()});
  cylinder["bottom_scale"] = cylinder["top_scale"] = 1;
  return cylinder;
}

Json triangles_of(const Geom& geom, const Json& mesh) {
  auto triangles = geom.solid(geom.size);
  triangles.erase("size");
  triangles["points"] = Json::array();
  const auto& numbers = mesh["vertices"];
  for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
    triangles["points"].push_back(vector_of(numbers[i], numbers[i + 1], numbers[i + 2]));
  triangles["colors"] = Json::array();
  triangles["indices"] = mesh["faces"];
  return triangles;
}

void add_geom(const Json& json, Json& entity) {
  const Geom geom(json);
  const auto r = geom.size.x();
  if (json.contains("mesh")) {
    entity["triangles"].push_back(triangles_of(geom, json["mesh"]));
  } else if (geom.type == "plane") {
    const auto length = [](double half) { return half > 0 ? 2 * half : endless_m; };
    entity["cubes"].push_back(geom.solid({length(geom.size.x()), length(geom.size.y()), plane_thickness_m}));
  } else if (geom.type == "box") {
    entity["cubes"].push_back(geom.solid(2 * geom.size));
  } else if (geom.type == "sphere") {
    entity["spheres"].push_back(geom.solid({2 * r, 2 * r, 2 * r}));
  } else if (geom.type == "ellipsoid") {
    entity["spheres"].push_back(geom.solid(2 * geom.size));
  } else if (geom.type == "cylinder" || geom.type == "capsule") {
    entity["cylinders"].push_back(cylinder_of(geom));
    const Vec3 end = geom.rotation * Vec3(0, 0, geom.size.y());
    if (geom.type == "capsule")
      for (const Vec3& at : {Vec3(geom.place + end), Vec3(geom.place - end)})
        entity["spheres"].push_back(geom.solid({2 * r, 2 * r, 2 * r}, at));
  }
}

Json entity_of(const std::string& body) {
  Json entity{{"timestamp", foxglove_time({})},
              {"frame_id", body},
              {"id", body},
              {"lifetime", foxglove_time({})},
              {"frame_locked", true}};
  for (const char* part :
       {"metadata", "arrows", "cubes", "spheres", "cylinders", "lines", "triangles", "texts", "models"})
    entity[part] = Json::array();
  return entity;
}

}  // namespace

Json foxglove_time(SimTime t) {
  constexpr std::int64_t second_us = 1000000;
  return {{"sec", t.us / second_us}, {"nsec", t.us % second_us * 1000}};
}

Json scene_update_of(const Json& scene) {
  Json update{{"deletions", Json::array()}, {"entities", Json::array()}};
  std::map<std::string, std::size_t> entities;
  for (const auto& geom : scene["geoms"]) {
    const auto body = text_of(geom, "body");
    const auto [entity, fresh] = entities.emplace(body, update["entities"].size());
    if (fresh) update["entities"].push_back(entity_of(body));
    add_geom(geom, update["entities"][entity->second]);
  }
  return update;
}

Json frame_transforms_of(SimTime t, const BodyPoses& bodies) {
  Json transforms = Json::array();
  for (const auto& [name, pose] : bodies)
    if (name != world)
      transforms.push_back({{"timestamp", foxglove_time(t)},
                            {"parent_frame_id", world},
                            {"child_frame_id", name},
                            {"translation", vector_of(pose[0], pose[1], pose[2])},
                            {"rotation", quaternion_of(pose[3], pose[4], pose[5], pose[6])}});
  return {{"transforms", std::move(transforms)}};
}

}  // namespace continua
