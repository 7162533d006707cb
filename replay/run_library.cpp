#include "replay/run_library.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view suffix = ".run.jsonl";
constexpr std::size_t most_held = 8;  // indexes kept open

bool is_letter_or_digit(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string without_suffix(std::string name) {
  for (const std::string_view end : {suffix, std::string_view(".jsonl")})
    if (name.size() > end.size() && name.ends_with(end)) return name.substr(0, name.size() - end.size());
  return name;
}

// "paper/one breath" -> "paper.one_breath"
std::string id_of(const std::string& name) {
  std::string id;
  for (const char c : name) id += is_letter_or_digit(c) || c == '-' || c == '_' || c == '.' ? c : c == '/' ? '.' : '_';
  return id;
}

// The logs below a folder, as paths relative to it.
std::vector<fs::path> logs_below(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code problem;
  fs::recursive_directory_iterator at(folder, fs::directory_options::skip_permission_denied, problem), end;
  for (; !problem && at != end; at.increment(problem))
    if (at->is_regular_file(problem) && at->path().filename().string().ends_with(suffix))
      found.push_back(at->path().lexically_relative(folder));
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

std::vector<RunFile> RunLibrary::runs() const {
  std::vector<RunFile> found;
  std::set<std::string> paths, ids;
  std::vector<RunFile> added;
  {
    const std::lock_guard lock(mutex_);
    added = added_;
  }
  for (const auto& run : added) ids.insert(run.id);
  const auto add = [&](const fs::path& path, const std::string& relative) {
    std::error_code problem;
    const auto real = fs::weakly_canonical(path, problem).string();
    if (!paths.insert(real).second) return;
    const auto name = without_suffix(relative);
    auto id = id_of(name);
    for (int copy = 2; !ids.insert(id).second; ++copy) id = fmt::format("{}-{}", id_of(name), copy);
    found.push_back({id, path.string(), name, ""});
  };
  for (const auto& path : paths_) {
    std::error_code problem;
    if (fs::is_directory(path, problem))
      for (const auto& relative : logs_below(path)) add(fs::path(path) / relative, relative.string());
    else
      add(path, fs::path(path).filename().string());
  }
  found.insert(found.end(), added.begin(), added.end());
  return found;
}

std::string RunLibrary::add(const std::string& name, const std::string& path, const std::string& what_if_of) {
  const auto known = runs();
  const auto is_known = [&](const std::string& id) {
    return std::any_of(known.begin(), known.end(), [&](const RunFile& run) { return run.id == id; });
  };
  auto id = name;
  for (int copy = 2; is_known(id); ++copy) id = fmt::format("{}-{}", name, copy);
  const std::lock_guard lock(mutex_);
  added_.push_back({id, path, id, what_if_of});
  return id;
}

Result<std::shared_ptr<const RunIndex>> RunLibrary::open(const std::string& id) {
  const auto all = runs();
  const auto file = std::find_if(all.begin(), all.end(), [&](const RunFile& run) { return run.id == id; });
  if (file == all.end()) return std::shared_ptr<const RunIndex>();
  std::error_code problem;
  const auto bytes = fs::file_size(file->path, problem);
  const auto written = fs::last_write_time(file->path, problem);

  const std::lock_guard lock(mutex_);
  const auto held = std::find_if(held_.begin(), held_.end(), [&](const Held& one) { return one.path == file->path; });
  if (held != held_.end()) {
    if (held->bytes == bytes && held->written == written) {
      held_.splice(held_.begin(), held_, held);
      return held_.front().run;
    }
    held_.erase(held);
  }
  auto run = RunIndex::open(file->path);
  if (!run) return run.error();
  held_.push_front({file->path, bytes, written, std::make_shared<const RunIndex>(*std::move(run))});
  if (held_.size() > most_held) held_.pop_back();
  return held_.front().run;
}

}  // namespace continua
