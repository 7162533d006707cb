#include "continua/replay/inspector/run_library.h"

#include <algorithm>
#include <chrono>
#include <set>

#include <fmt/format.h>

#include "continua/core/gzip_name.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view suffix = ".run.jsonl";
constexpr std::chrono::seconds lately{15};          // a log written to since then goes on
constexpr std::size_t most_held = 8;                // indexes kept open
constexpr std::size_t most_held_records = 3000000;  // of all but the one used last, at some 60 bytes each

bool is_letter_or_digit(char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string without_suffix(const std::string& path) {
  std::string name(without_gzip_ending(path));
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
    if (at->is_regular_file(problem) && without_gzip_ending(at->path().string()).ends_with(suffix))
      found.push_back(at->path().lexically_relative(folder));
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

FileState file_state(const std::string& path) {
  std::error_code problem;
  FileState state{fs::file_size(path, problem), {}};
  if (problem) return {};
  state.written = fs::last_write_time(path, problem);
  return state;
}

std::vector<RunFile> RunLibrary::runs() {
  std::vector<RunFile> found;
  std::set<std::string> paths, ids;
  std::vector<RunFile> added;
  {
    const std::lock_guard lock(mutex_);
    added = added_;
  }
  for (const auto& run : added) ids.insert(run.id);
  const auto add = [&](const fs::path& path, const std::string& relative, const std::string& served) {
    std::error_code problem;
    const auto real = fs::weakly_canonical(path, problem).string();
    if (!paths.insert(real).second) return;
    const auto name = without_suffix(relative);
    auto id = id_of(name);
    for (int copy = 2; !ids.insert(id).second; ++copy) id = fmt::format("{}-{}", id_of(name), copy);
    found.push_back({id, path.string(), name, "", served});
  };
  for (const auto& path : paths_) {
    std::error_code problem;
    if (fs::is_directory(path, problem))
      for (const auto& relative : logs_below(path)) add(fs::path(path) / relative, relative.string(), path);
    else
      add(path, fs::path(path).filename().string(), fs::path(path).parent_path().string());
  }
  found.insert(found.end(), added.begin(), added.end());
  const std::lock_guard lock(mutex_);
  known_.clear();
  for (const auto& file : found) known_.emplace(file.id, file);
  return found;
}

std::string RunLibrary::add(const std::string& name, const std::string& path, const std::string& what_if_of) {
  const auto all = runs();
  std::error_code problem;
  for (const auto& run : all)
    if (fs::equivalent(run.path, path, problem)) return run.id;
  const auto is_known = [&](const std::string& id) {
    return std::any_of(all.begin(), all.end(), [&](const RunFile& run) { return run.id == id; });
  };
  auto id = name;
  for (int copy = 2; is_known(id); ++copy) id = fmt::format("{}-{}", name, copy);
  const std::lock_guard lock(mutex_);
  added_.push_back({id, path, id, what_if_of, fs::path(path).parent_path().string()});
  return id;
}

bool RunLibrary::is_being_written(const std::string& path, const FileState& log) const {
  if (is_open_ && is_open_(path)) return true;
  const auto age = fs::file_time_type::clock::now() - log.written;
  // A clock that was set back makes files of the future, which stay so for hours.
  return age < lately && age > -lately;
}

std::optional<RunFile> RunLibrary::find(const std::string& id) {
  {
    const std::lock_guard lock(mutex_);
    const auto known = known_.find(id);
    std::error_code problem;
    if (known != known_.end() && fs::exists(known->second.path, problem)) return known->second;
  }
  for (auto& file : runs())
    if (file.id == id) return std::move(file);
  return std::nullopt;
}

std::vector<std::string> RunLibrary::folders() const {
  std::vector<std::string> found;
  std::error_code problem;
  for (const auto& path : paths_)
    if (fs::is_directory(path, problem)) found.push_back(path);
  return found;
}

// Moved to the front. Null if it is not held and none is to be made.
std::shared_ptr<RunLibrary::Held> RunLibrary::held(const std::string& path, bool make) {
  const std::lock_guard lock(mutex_);
  const auto known = std::find_if(held_.begin(), held_.end(), [&](const auto& one) { return one->path == path; });
  if (known == held_.end() && !make) return nullptr;
  if (known == held_.end())
    held_.push_front(std::make_shared<Held>(path));
  else
    held_.splice(held_.begin(), held_, known);
  std::size_t count = 0, records = 0;
  std::erase_if(held_, [&](const auto& one) {
    if (count > 0) records += one->records;
    return ++count > most_held || records > most_held_records;
  });
  return held_.front();
}

Result<std::shared_ptr<const RunIndex>> RunLibrary::read(Held& held) {
  const std::lock_guard lock(held.reading);
  const auto state = file_state(held.path);
  if (held.run && held.state == state) return held.run;
  const bool grown = held.run && state.bytes > held.state.bytes;
  auto run = grown ? RunIndex::grown(*held.run) : RunIndex::open(held.path);
  if (!run) {
    held.run = nullptr;
    return run.error();
  }
  held.state = state;
  held.records = run->size();
  held.run = std::make_shared<const RunIndex>(*std::move(run));
  return held.run;
}

Result<std::shared_ptr<const RunIndex>> RunLibrary::open(const std::string& id) {
  const auto file = find(id);
  if (!file) return std::shared_ptr<const RunIndex>();
  return read(*held(file->path, true));
}

Result<std::shared_ptr<const RunIndex>> RunLibrary::look_into(const RunFile& file) {
  if (const auto known = held(file.path, false)) return read(*known);
  auto run = RunIndex::open(file.path);
  if (!run) return run.error();
  return std::make_shared<const RunIndex>(*std::move(run));
}

}  // namespace continua
