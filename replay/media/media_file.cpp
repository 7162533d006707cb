#include "continua/replay/media/media_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, std::string_view>, 13> types = {{{".webm", "video/webm"},
                                                                                  {".mp4", "video/mp4"},
                                                                                  {".m4v", "video/mp4"},
                                                                                  {".mov", "video/quicktime"},
                                                                                  {".mpg", "video/mpeg"},
                                                                                  {".ogv", "video/ogg"},
                                                                                  {".wav", "audio/x-wav"},
                                                                                  {".mp3", "audio/mpeg"},
                                                                                  {".ogg", "audio/ogg"},
                                                                                  {".oga", "audio/ogg"},
                                                                                  {".opus", "audio/ogg"},
                                                                                  {".m4a", "audio/mp4"},
                                                                                  {".flac", "audio/flac"}}};

std::string endings() {
  std::string all;
  for (const auto& [ending, type] : types) all += fmt::format("{}{}", all.empty() ? "" : ", ", ending);
  return all;
}

// A place that need not be there, with those links followed that are.
fs::path real(const fs::path& path) {
  std::error_code problem;
  const auto found = fs::weakly_canonical(fs::absolute(path.empty() ? "." : path, problem), problem);
  return problem ? fs::path() : found;
}

bool is_below(const fs::path& path, const fs::path& folder) {
  if (path.empty() || folder.empty()) return false;
  const auto way = path.lexically_relative(folder);
  return !way.empty() && *way.begin() != "..";
}

}  // namespace

std::vector<MediaFile> media_in(const Json& header) {
  std::vector<MediaFile> media;
  const auto& listed = member_of(header, "media");
  if (!listed.is_array()) return media;
  for (const auto& one : listed) {
    MediaFile found{text_of(one, "file"), text_of(one, "kind"), text_of(one, "label")};
    if (found.file.empty()) continue;
    const auto type = media_type(found.file);
    if (found.kind != "video" && found.kind != "audio") found.kind = type.substr(0, type.find('/'));
    if (const auto& offset = member_of(one, "offset"); offset.is_number()) found.offset_s = offset.get<double>();
    media.push_back(std::move(found));
  }
  return media;
}

std::string media_type(const std::string& file) {
  auto ending = fs::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const auto found = std::find_if(types.begin(), types.end(), [&](const auto& type) { return type.first == ending; });
  return found == types.end() ? "" : std::string(found->second);
}

Result<std::string> find_media(const std::string& file, const std::string& folder, const std::string& within) {
  if (file.find('\0') != std::string::npos || media_type(file).empty())
    return Error{file, "is not named as a recording is; expected " + endings()};
  const auto path = real(fs::path(folder) / file);
  if (!is_below(path, real(within))) return Error{file, "lies outside of the folder of the trace"};
  std::error_code problem;
  if (!fs::is_regular_file(path, problem)) return Error{file, "is not there"};
  // A link may be named as a recording and lead to something else.
  if (media_type(path.string()).empty()) return Error{file, "is a link to something that is no recording"};
  return path.string();
}

}  // namespace continua
