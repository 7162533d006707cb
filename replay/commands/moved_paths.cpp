#include "continua/replay/commands/moved_paths.h"

#include <filesystem>

#include "continua/knowledge_files/data_paths.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

// A path of the header, relative to the trace, as it reads from another folder.
template <class Resolve>
void move_path(std::string& name, const fs::path& from, const fs::path& to, Resolve resolve) {
  if (name.empty() || fs::path(name).is_absolute()) return;
  const Result<std::string> path = resolve(name);
  if (!path) return;
  std::error_code unknown;
  if (fs::equivalent(*path, from / name, unknown)) name = fs::proximate(*path, to, unknown).generic_string();
}

}  // namespace

void move_media(Json& header, const fs::path& from, const fs::path& to) {
  if (!header.is_object() || !header.contains("media")) return;
  for (auto& one : header["media"]) {
    const fs::path file(one.value("file", ""));
    std::error_code unknown;
    if (!file.empty() && file.is_relative())
      one["file"] = fs::proximate(fs::absolute(from / file), fs::absolute(to), unknown).generic_string();
  }
}

Outcome move_paths(TraceHeader& header, const std::string& trace, const std::string& output,
                   const std::string& knowledge) {
  const auto data = find_data_paths(knowledge);
  if (!data) return data.error();
  const auto folder_of = [](const std::string& file) {
    const auto folder = file == "-" ? fs::path() : fs::path(file).parent_path();
    return folder.empty() ? fs::path(".") : folder;
  };
  const auto from = folder_of(trace), to = folder_of(output);
  move_path(header.scene, from, to, [&](const auto& name) { return resolve_scene(name, *data, from, trace); });
  move_path(header.machine, from, to, [&](const auto& name) { return resolve_machine(name, *data, from, trace); });
  move_media(header.json, from, to);
  return std::nullopt;
}

Outcome write_moved(Trace trace, const std::string& from, const std::string& output, const std::string& knowledge) {
  if (auto problem = move_paths(trace.header, from, output, knowledge)) return problem;
  return write_file(output, write_trace(trace));
}

}  // namespace continua
