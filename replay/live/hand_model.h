// The model that finds hands in a camera's pictures, as a browser loads it: the files of npm's @mediapipe/hands
// (web/CMakeLists.txt), which lie in a folder "hands" beside the data, or beside the program in a build tree.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace continua {

/// None: it is not installed, or the program's data are not found.
std::optional<std::filesystem::path> hand_model_folder();

/// The media type of a file of the model by its name; none: such a file is not for browsers.
std::optional<std::string> hand_model_type(std::string_view name);

}  // namespace continua
