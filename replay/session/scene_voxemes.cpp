#include "continua/replay/session/scene_voxemes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/core/located_json.h"

namespace continua {

namespace {

std::string type_of(const SceneObject& object) {
  const auto type = object.attributes.find("type");
  return type == object.attributes.end() ? std::string() : type->second;
}

std::vector<const SceneObject*> unknown_objects(const Scene& scene, const Catalogue& voxemes) {
  std::vector<const SceneObject*> unknown;
  for (const auto& object : scene.objects())
    if (!voxemes.for_object(object.name, type_of(object))) unknown.push_back(&object);
  return unknown;
}

}  // namespace

std::vector<std::string> objects_without_voxeme(const Scene& scene, const Catalogue& voxemes) {
  std::vector<std::string> names;
  for (const auto* object : unknown_objects(scene, voxemes)) names.push_back(object->name);
  return names;
}

std::optional<Error> warning_of_voxemes(const Scene& scene, const Catalogue& voxemes, const std::string& knowledge) {
  const auto unknown = unknown_objects(scene, voxemes);
  if (unknown.empty()) return std::nullopt;
  std::vector<std::string> known;
  for (const auto& [key, voxeme] : voxemes.voxemes())
    if (key.first == Voxeme::Entity::object) known.push_back(key.second);
  std::vector<std::string> told;
  for (const auto* object : unknown) {
    const std::string type = type_of(*object), name = in_quotes(object->name);
    told.push_back(type.empty() ? fmt::format("{} (without a type)", name)
                                : fmt::format("{} of type {}{}", name, in_quotes(type), did_you_mean(type, known)));
  }
  return Error{scene.path(),
               fmt::format("no voxeme of {}: what can be done with {} is not known, and nothing is refused for it; "
                           "expected one of the object's name or type in {}/voxemes/objects",
                           fmt::join(told, ", "), unknown.size() == 1 ? "it" : "them", knowledge)};
}

}  // namespace continua
