#include "continua/replay/check/check_items.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/trace/trace_name.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

bool is_lexicon(const fs::path& path) { return is_folder(path) && path.parent_path().filename() == "lexicon"; }
bool is_machine(const fs::path& path) {
  return path.extension() == ".jff" || (path.extension() == ".json" && path.parent_path().filename() == "machines");
}
bool is_data(const fs::path& path) {
  const auto folder = path.parent_path().filename();
  return path.extension() == ".json" && (folder == "phrases" || folder == "gestures");
}
bool is_voxemes(const fs::path& path) { return is_folder(path) && path.filename() == "voxemes"; }
bool is_approved_run(const fs::path& path) {
  const auto name = path.string();
  return without_gzip_ending(name).ends_with(".run.jsonl") || name.ends_with(".run.json");
}

ItemKind kind_of(const fs::path& path) {
  if (is_lexicon(path)) return ItemKind::lexicon;
  if (is_voxemes(path)) return ItemKind::voxemes;
  if (is_data(path)) return ItemKind::data;
  return without_gzip_ending(path.string()).ends_with(".jsonl") ? ItemKind::trace : ItemKind::machine;
}

void collect(const fs::path& path, std::vector<CheckItem>& items) {
  if (is_approved_run(path)) return;
  if (!is_folder(path) || is_lexicon(path) || is_voxemes(path))
    return items.push_back({path.lexically_normal(), kind_of(path), ""});
  std::vector<fs::path> entries;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(path, problem)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  for (const auto& entry : entries)
    if (is_folder(entry) || is_machine(entry) || is_data(entry) || is_trace_name(entry.string())) collect(entry, items);
}

std::string short_name(const fs::path& path) {
  return is_trace_name(path.string()) ? trace_name(path.string()) : path.stem().string();
}

// "traces-paper-one" of traces/paper/one.trace.jsonl.
std::string long_name(const fs::path& path) {
  std::string name;
  for (const auto& part : path.relative_path().parent_path())
    if (part != ".." && part != ".") name += part.string() + "-";
  return name + short_name(path);
}

void name_them(std::vector<CheckItem>& items) {
  std::map<std::string, int> times;
  for (const auto& item : items) ++times[short_name(item.path)];
  std::set<std::string> taken;
  for (auto& item : items) {
    const auto brief = short_name(item.path);
    const auto wanted = times[brief] == 1 ? brief : long_name(item.path);
    item.name = wanted;
    for (int i = 2; !taken.insert(item.name).second; ++i) item.name = fmt::format("{}-{}", wanted, i);
  }
}

}  // namespace

Result<std::vector<CheckItem>> items_of(const std::vector<std::string>& paths) {
  std::vector<CheckItem> items;
  for (const auto& path : paths) {
    std::error_code problem;
    if (!fs::exists(path, problem)) return Error{path, "there is no such file or folder"};
    const auto before = items.size();
    collect(fs::path(path).lexically_normal(), items);
    if (items.size() == before) return Error{path, "has nothing to check; expected traces, machines or knowledge"};
  }
  name_them(items);
  return items;
}

}  // namespace continua
