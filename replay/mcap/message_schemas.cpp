#include "continua/replay/mcap/message_schemas.h"

#include <map>

#include "continua/core/located_json.h"

namespace continua {
namespace {

const Json a_text{{"type", "string"}}, a_number{{"type", "number"}}, an_integer{{"type", "integer"}},
    a_truth{{"type", "boolean"}};

Json object(std::initializer_list<std::pair<const char*, Json>> members, const char* title = nullptr) {
  Json schema{{"type", "object"}};
  if (title) schema["title"] = title;
  auto& properties = schema["properties"] = Json::object();
  for (const auto& [name, member] : members) properties[name] = member;
  return schema;
}

Json list(const Json& items) { return {{"type", "array"}, {"items", items}}; }

// Foxglove's schemas, as far as their viewers need them.
Json log() {
  const auto time = object({{"sec", an_integer}, {"nsec", an_integer}}, "time");
  return object({{"timestamp", time},
                 {"level", an_integer},
                 {"message", a_text},
                 {"name", a_text},
                 {"file", a_text},
                 {"line", an_integer}});
}

const Json& vector() {
  static const auto schema = object({{"x", a_number}, {"y", a_number}, {"z", a_number}}, "foxglove.Vector3");
  return schema;
}

const Json& quaternion() {
  static const auto schema =
      object({{"x", a_number}, {"y", a_number}, {"z", a_number}, {"w", a_number}}, "foxglove.Quaternion");
  return schema;
}

Json frame_transforms() {
  const auto time = object({{"sec", an_integer}, {"nsec", an_integer}}, "time");
  return object({{"transforms", list(object({{"timestamp", time},
                                             {"parent_frame_id", a_text},
                                             {"child_frame_id", a_text},
                                             {"translation", vector()},
                                             {"rotation", quaternion()}},
                                            "foxglove.FrameTransform"))}});
}

Json scene_update() {
  const auto time = object({{"sec", an_integer}, {"nsec", an_integer}}, "time");
  const auto duration = object({{"sec", an_integer}, {"nsec", an_integer}}, "duration");
  const auto color = object({{"r", a_number}, {"g", a_number}, {"b", a_number}, {"a", a_number}}, "foxglove.Color");
  const auto pose = object({{"position", vector()}, {"orientation", quaternion()}}, "foxglove.Pose");
  const auto solid = object({{"pose", pose}, {"size", vector()}, {"color", color}});
  auto cylinder = solid;
  cylinder["properties"]["bottom_scale"] = cylinder["properties"]["top_scale"] = a_number;
  const auto triangles = object({{"pose", pose},
                                 {"points", list(vector())},
                                 {"color", color},
                                 {"colors", list(color)},
                                 {"indices", list(an_integer)}});
  const auto nothing = list(object({}));
  const auto entity = object({{"timestamp", time},
                              {"frame_id", a_text},
                              {"id", a_text},
                              {"lifetime", duration},
                              {"frame_locked", a_truth},
                              {"metadata", list(object({{"key", a_text}, {"value", a_text}}, "foxglove.KeyValuePair"))},
                              {"arrows", nothing},
                              {"cubes", list(solid)},
                              {"spheres", list(solid)},
                              {"cylinders", list(cylinder)},
                              {"lines", nothing},
                              {"triangles", list(triangles)},
                              {"texts", nothing},
                              {"models", nothing}},
                             "foxglove.SceneEntity");
  const auto deletion =
      object({{"timestamp", time}, {"type", an_integer}, {"id", a_text}}, "foxglove.SceneEntityDeletion");
  return object({{"deletions", list(deletion)}, {"entities", list(entity)}});
}

// Ours (MCAP.md).
Json event() {
  return object(
      {{"t", a_number}, {"kind", a_text}, {"text", a_text}, {"name", a_text}, {"hand", a_text}, {"until", a_number}});
}

Json stack() {
  const auto slot = object({{"slot", a_text}, {"term", a_text}});
  const auto symbol = object({{"id", an_integer}, {"made", an_integer}, {"slots", list(slot)}});
  return object({{"n", an_integer}, {"depth", an_integer}, {"symbols", list(symbol)}});
}

std::string document(Json schema, std::string_view name) {
  Json whole{{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", name}};
  for (const auto& [key, value] : schema.items())
    if (!whole.contains(key)) whole[key] = value;
  return whole.dump();
}

const std::map<std::string_view, std::string>& json_schemas() {
  static const auto schemas = [] {
    std::map<std::string_view, std::string> made;
    const auto add = [&](std::string_view name, const Json& schema) { made[name] = document(schema, name); };
    add("foxglove.Log", log());
    add("foxglove.FrameTransforms", frame_transforms());
    add("foxglove.SceneUpdate", scene_update());
    add("continua.Event", event());
    add("continua.State", object({{"n", an_integer}, {"state", a_text}, {"transition", a_text}, {"input", a_text}}));
    add("continua.Stack", stack());
    add("continua.Act",
        object({{"n", an_integer}, {"act", an_integer}, {"program", a_text}, {"status", a_text}, {"reason", a_text}}));
    add("continua.Gesture", object({{"n", an_integer}, {"gesture", a_text}}));
    add("continua.Note", object({{"n", an_integer}, {"to", an_integer}, {"until", a_number}, {"text", a_text}}));
    return made;
  }();
  return schemas;
}

const std::map<std::string_view, std::string_view> ros_schemas = {
    {"std_msgs/msg/String", "string data\n"},
    {"hri_msgs/msg/LiveSpeech",
     "std_msgs/Header header\nstring incremental\nstring final\nfloat64 confidence\n"
     "================================================================================\n"
     "MSG: std_msgs/Header\nbuiltin_interfaces/Time stamp\nstring frame_id\n"
     "================================================================================\n"
     "MSG: builtin_interfaces/Time\nint32 sec\nuint32 nanosec\n"}};

}  // namespace

McapChannel json_channel(std::string topic, std::string_view schema) {
  return {std::move(topic), "json", {std::string(schema), "jsonschema", json_schemas().at(schema)}};
}

McapChannel ros_channel(std::string topic, std::string_view type) {
  return {std::move(topic), "cdr", {std::string(type), "ros2msg", std::string(ros_schemas.at(type))}};
}

}  // namespace continua
