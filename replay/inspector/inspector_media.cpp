// The inspector's addresses of recordings that lie beside a run's trace.
#include <algorithm>
#include <charconv>
#include <filesystem>

#include <fmt/format.h>

#include "continua/replay/inspector/inspector_api.h"
#include "continua/replay/media/media_peaks.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_peaks = 16;  // recordings of which they are kept

// ID and I of "/api/runs/ID/media/I"; nothing for any other path.
std::optional<std::pair<std::string, std::size_t>> numbered(const std::string& path) {
  constexpr std::string_view before = "/api/runs/", between = "/media/";
  const auto at = path.rfind(between);
  if (!path.starts_with(before) || at == std::string::npos || at <= before.size()) return std::nullopt;
  const char* const from = path.data() + at + between.size();
  const char* const end = path.data() + path.size();
  std::size_t number = 0;
  const auto [last, problem] = std::from_chars(from, end, number);
  if (problem != std::errc() || last != end) return std::nullopt;
  return std::pair(path.substr(before.size(), at - before.size()), number);
}

}  // namespace

// The trace is beside the run, or in one of the folders that are served. A what-if has the recordings of its original.
Result<RunMedia> InspectorApi::media_of(const std::string& id) {
  auto file = library_.find(id);
  for (int steps = 0; file && !file->what_if_of.empty() && steps < 100; ++steps) file = library_.find(file->what_if_of);
  if (!file) return Error{"", fmt::format("there is no run '{}'", id)};
  const auto opened = library_.open(file->id);
  if (!opened) return opened.error();
  if (!*opened) return Error{"", fmt::format("there is no run '{}'", id)};
  std::vector<TracePlace> places = {{fs::path(file->path).parent_path().string(), file->served}};
  for (const auto& folder : library_.folders()) places.push_back({folder, folder});
  return media_of_run(**opened, places);
}

ApiResponse InspectorApi::media(const std::string& id) {
  const auto media = media_of(id);
  if (!media) return api_error(404, media.error().text());
  Json listed = Json::array();
  for (const auto& one : media->files) {
    listed.push_back({{"file", one.file}, {"kind", one.kind}, {"label", one.label}, {"offset", one.offset_s}});
    const auto path = find_media(one.file, media->folder, media->within);
    std::error_code problem;
    if (path) {
      listed.back()["type"] = media_type(*path);
      listed.back()["bytes"] = fs::file_size(*path, problem);
    } else {
      listed.back()["problem"] = path.error().sentence;
    }
  }
  return answer(Json{{"media", listed}});
}

std::variant<ServedMedia, ApiResponse> InspectorApi::media_file(std::string_view target) {
  return media_at(split_target(target).path);
}

std::variant<ServedMedia, ApiResponse> InspectorApi::media_at(const std::string& path) {
  const auto wanted = numbered(path);
  if (!wanted) return api_error(404, fmt::format("there is nothing at {}", path));
  const auto& [id, number] = *wanted;
  const auto media = media_of(id);
  if (!media) return api_error(404, media.error().text());
  if (number >= media->files.size())
    return api_error(404, fmt::format("the run has {} recordings; expected a number below that", media->files.size()));
  const auto& file = media->files[number].file;
  const auto found = find_media(file, media->folder, media->within);
  if (!found) return api_error(404, fmt::format("the recording '{}' {}", file, found.error().sentence));
  return ServedMedia{*found, media_type(*found)};
}

ApiResponse InspectorApi::peaks(std::string_view path) {
  path.remove_suffix(std::string_view("/peaks").size());
  const auto found = media_at(std::string(path));
  if (const auto* refused = std::get_if<ApiResponse>(&found)) return *refused;
  const auto& recording = std::get<ServedMedia>(found).path;
  const auto state = file_state(recording);
  const auto key = fmt::format("{} {} {}", recording, state.bytes, state.written.time_since_epoch().count());
  const std::lock_guard lock(peaks_mutex_);
  const auto known = std::find_if(peaks_.begin(), peaks_.end(), [&](const auto& one) { return one.first == key; });
  if (known != peaks_.end()) return {200, "application/json", known->second};
  auto peaks = peaks_of(recording);
  if (!peaks) return answer(Json{{"problem", peaks.error().sentence}});
  peaks_.emplace_front(key, *peaks);
  if (peaks_.size() > most_peaks) peaks_.pop_back();
  return {200, "application/json", *std::move(peaks)};
}

}  // namespace continua
