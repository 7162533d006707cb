#include "continua/replay/live/hand_model.h"

#include <algorithm>
#include <cctype>
#include <utility>

#include "continua/knowledge_files/data_paths.h"

namespace continua {
namespace fs = std::filesystem;

std::optional<fs::path> hand_model_folder() {
  const auto data = find_data_paths();
  if (!data) return std::nullopt;
  std::error_code problem;
  const auto program = fs::read_symlink("/proc/self/exe", problem);
  for (const auto& folder : {data->mjcf.parent_path() / "hands", program.parent_path() / "hands"})
    if (fs::is_regular_file(folder / "hands.js", problem)) return folder;
  return std::nullopt;
}

std::optional<std::string> hand_model_type(std::string_view name) {
  constexpr std::pair<std::string_view, const char*> types[] = {
      {".js", "text/javascript; charset=utf-8"}, {".wasm", "application/wasm"},
      {".data", "application/octet-stream"},     {".binarypb", "application/octet-stream"},
      {".tflite", "application/octet-stream"},   {".txt", "text/plain; charset=utf-8"}};
  const bool plain =
      std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '.'; });
  for (const auto& [ending, type] : types)
    if (plain && name.ends_with(ending)) return type;
  return std::nullopt;
}

}  // namespace continua
