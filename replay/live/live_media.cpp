#include "continua/replay/live/live_media.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "continua/core/growing_file.h"
#include "continua/core/put_in_place.h"
#include "continua/core/replaced_file.h"
#include "continua/replay/media/ffmpeg.h"
#include "continua/replay/trace/trace_name.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view webm_begin = "\x1A\x45\xDF\xA3";
constexpr double most_copying_s = 60;

// With a table of its instants and its length, which a browser that records cannot know.
void make_seekable(const std::string& path) {
  const auto copy = path + ".part.webm";
  std::error_code ignored;
  if (run_ffmpeg(path, {"-c", "copy", "-f", "webm", "file:" + copy}, most_copying_s, [](std::string_view) {}) ||
      put_in_place(copy, path))
    fs::remove(copy, ignored);
}

}  // namespace

Result<LiveMedia::Growing> LiveMedia::begun(const MediaPart& part) const {
  if (part.source != "camera" && part.source != "microphone")
    return Error{"", fmt::format("found the source {}; expected camera or microphone", in_quotes(part.source))};
  const auto type = part.type.substr(0, part.type.find(';'));
  if ((type != "video/webm" && type != "audio/webm") || !part.bytes.starts_with(webm_begin))
    return Error{"", "expected a recording of the type video/webm or audio/webm"};
  const auto folder = fs::path(trace_path_).parent_path();
  Growing fresh;
  for (int number = 1;; ++number) {
    fresh.file.file = fmt::format("{}.{}{}.webm", trace_name(trace_path_), part.source,
                                  number == 1 ? "" : fmt::format("-{}", number));
    fresh.path = (folder / fresh.file.file).string();
    std::error_code problem;
    if (!fs::exists(fs::symlink_status(fresh.path, problem))) break;
  }
  fresh.file.kind = type.substr(0, type.find('/'));
  fresh.file.label = part.source;
  fresh.file.offset_s = part.at == SimTime{} ? 0 : -part.at.seconds();
  return fresh;
}

Outcome LiveMedia::add(const MediaPart& part) {
  const std::lock_guard lock(mutex_);
  if (finished_) return Error{"", "the session has ended"};
  const auto known = known_.find({part.source, part.take});
  const auto done = known == known_.end() ? 0 : files_[known->second].parts;
  if (part.part + 1 == done) return std::nullopt;
  if (part.part != done)
    return Error{"", fmt::format("found part {} of the recording; expected part {}", part.part, done)};
  if (bytes_ + part.bytes.size() > most_live_media)
    return Error{"", fmt::format("the recordings of a session may have {} MiB", most_live_media >> 20)};
  auto fresh = known == known_.end() ? begun(part) : Result<Growing>(files_[known->second]);
  if (!fresh) return fresh.error();
  if (auto unwritten = GrowingFile(fresh->path, GrowingFile::Begin::after).add(part.bytes)) return *unwritten;
  bytes_ += part.bytes.size();
  fresh->bytes += part.bytes.size();
  ++fresh->parts;
  if (known == known_.end()) {
    known_.emplace(std::pair(part.source, part.take), files_.size());
    files_.push_back(*std::move(fresh));
  } else {
    files_[known->second] = *std::move(fresh);
  }
  return std::nullopt;
}

std::vector<MediaFile> LiveMedia::finish() {
  const std::lock_guard lock(mutex_);
  std::vector<MediaFile> media;
  for (const auto& one : files_) {
    if (!finished_) make_seekable(one.path);
    media.push_back(one.file);
  }
  finished_ = true;
  return media;
}

Outcome name_media(const std::string& trace_path, const std::vector<MediaFile>& media) {
  if (media.empty()) return std::nullopt;
  const auto text = read_file(trace_path);
  if (!text) return text.error();
  const auto line = std::min(text->find('\n'), text->size());
  auto header = parse_json_line(std::string_view(*text).substr(0, line), trace_path, 1);
  if (!header) return header.error();
  for (const auto& one : media) {
    Json listed{{"file", one.file}, {"kind", one.kind}, {"label", one.label}};
    if (one.offset_s != 0) listed["offset"] = one.offset_s;
    (*header)["media"].push_back(listed);
  }
  return replace_file(trace_path, compact(*header) + text->substr(line));
}

}  // namespace continua
