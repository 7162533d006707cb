// Shipped scenes with other arms in them: ours, and those of tests/simulation/arms.
#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/simulation/scene.h"
#include "support/folders.h"
#include "support/temporary_folder.h"

namespace continua {

inline const std::string root = source_dir();
inline const std::string others = root + "/tests/simulation/arms/";
inline const std::array arms = {root + "/mjcf/avatar/arm7.xml",
                                root + "/mjcf/avatar/arm6.xml",
                                others + "seven_axis.xml",
                                others + "panda.xml",
                                others + "ur5e.xml",
                                others + "sawyer.xml"};

inline std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
  return text;
}

inline std::string text_of(const std::string& path) {
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The words by which a scene tells of an arm whose file does not say (arms/told.json); empty: its file says all.
inline std::string told_of(const std::string& arm) {
  static const auto told = Json::parse(text_of(others + "told.json"));
  return told.value(std::filesystem::path(arm).stem().string(), "");
}

/// A shipped scene with another arm in it.
inline Scene scene_with(const std::string& arm, const std::string& scene,
                        const std::vector<ObjectOverride>& overrides = {}) {
  const TemporaryFolder folder;
  auto text = text_of(root + "/mjcf/scenes/" + scene + ".xml");
  for (const char* shipped : {"../avatar/arm7.xml", "../avatar/arm6.xml"}) text = replaced(text, shipped, arm);
  if (const auto words = told_of(arm); !words.empty())
    text = replaced(text, "</custom>", "<text name=\"avatar\" data=\"" + words + "\"/></custom>");
  return load_scene(folder.file("scene.xml", replaced(text, "../objects", root + "/mjcf/objects")), overrides).value();
}

}  // namespace continua
