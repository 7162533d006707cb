// Shipped scenes with other arms in them: ours, and those of tests/simulation/arms.
#pragma once

#include <array>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "continua/simulation/scene.h"
#include "support/temporary_folder.h"

namespace continua {

inline const std::string root = CONTINUA_SOURCE_DIR;
inline const std::string others = root + "/tests/simulation/arms/";
inline const std::array arms = {root + "/mjcf/avatar/arm7.xml",
                                root + "/mjcf/avatar/arm6.xml",
                                others + "seven_axis.xml",
                                others + "panda.xml",
                                others + "ur5e.xml",
                                others + "sawyer.xml"};

/// What a scene tells of the arms whose files do not say.
inline const std::map<std::string, std::string> told = {
    {arms[3], "base=0,0.62,-0.05,-90 home=0,0,0,-1.9,0,1.9,-0.7853"},
    {arms[4], "base=0,0.62,0,180 hand=gripper_base"},
    {arms[5], "base=0,0.85,0.1,-90 pads=l_fingerpad_g0,r_fingerpad_g0 grip=grip_site"},
};

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

/// A shipped scene with another arm in it.
inline Scene scene_with(const std::string& arm, const std::string& scene,
                        const std::vector<ObjectOverride>& overrides = {}) {
  const TemporaryFolder folder;
  auto text = text_of(root + "/mjcf/scenes/" + scene + ".xml");
  for (const char* shipped : {"../avatar/arm7.xml", "../avatar/arm6.xml"}) text = replaced(text, shipped, arm);
  if (const auto words = told.find(arm); words != told.end())
    text = replaced(text, "</custom>", "<text name=\"avatar\" data=\"" + words->second + "\"/></custom>");
  return load_scene(folder.file("scene.xml", replaced(text, "../objects", root + "/mjcf/objects")), overrides).value();
}

}  // namespace continua
