#include "continua/replay/inspector/run_dropped.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "continua/core/gzip_name.h"
#include "continua/core/located_json.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_text.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_coming = 4;
constexpr int most_begun = 1000;  // each takes a folder
constexpr std::size_t longest_name = 100;
constexpr auto gzip_magic = "\x1f\x8b";

bool is_key(const std::string& key) {
  return !key.empty() && key.size() <= longest_name &&
         std::all_of(key.begin(), key.end(), [](unsigned char c) { return std::isalnum(c) != 0; });
}

// "../talk 2.trace.jsonl" is "talk_2".
std::string stem_of(const std::string& name) {
  auto stem = fs::path(std::string(without_gzip_ending(name))).filename().string();
  for (const std::string_view end : {".run.jsonl", ".trace.jsonl", ".jsonl"})
    if (stem.size() > end.size() && stem.ends_with(end)) stem.resize(stem.size() - end.size());
  stem.resize(std::min(stem.size(), longest_name));
  for (auto& c : stem)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') c = '_';
  return stem.empty() ? "dropped" : stem;
}

void forget(const std::string& folder) {
  std::error_code ignored;
  fs::remove_all(folder, ignored);
}

}  // namespace

Result<std::optional<DroppedFile>> DroppedFiles::add(const DroppedPart& part) {
  const std::lock_guard lock(mutex_);
  if (!is_key(part.key)) return Error{"", "'file' must be letters and digits"};
  auto known = std::find_if(coming_.begin(), coming_.end(), [&](const Coming& one) { return one.key == part.key; });
  if (known == coming_.end()) {
    if (part.part != 0) return Error{"", "the file was given up; hand it over again"};
    auto begun = begin(part.key);
    if (!begun) return begun.error();
    known = coming_.insert(coming_.end(), *std::move(begun));
  }
  const auto give_up = [&](std::string why) {
    forget(known->folder);
    coming_.erase(known);
    return Error{"", std::move(why)};
  };
  if (part.part != known->parts) return give_up(fmt::format("part {} came; expected part {}", part.part, known->parts));
  known->bytes += part.bytes.size();
  if (known->bytes > most_dropped_bytes)
    return give_up(
        fmt::format("the file has more than {} MiB; expected a smaller one, or a command line: continua "
                    "serve FILE",
                    most_dropped_bytes >> 20));
  std::ofstream file(known->path, std::ios::binary | std::ios::app);
  file.write(part.bytes.data(), static_cast<std::streamsize>(part.bytes.size()));
  if (!file.flush()) return give_up("the file cannot be written here");
  ++known->parts;
  if (!part.last) return std::optional<DroppedFile>();
  auto done = whole(*known, part.name);
  if (!done) return give_up(done.error().sentence);
  coming_.erase(known);
  return std::optional(*std::move(done));
}

Result<DroppedFiles::Coming> DroppedFiles::begin(const std::string& key) {
  if (begun_ >= most_begun) return Error{"", fmt::format("{} files were taken; start the server anew", most_begun)};
  if (coming_.size() >= most_coming) {
    forget(coming_.front().folder);
    coming_.pop_front();
  }
  auto folder = temporary_.folder(fmt::format("dropped-{}", ++begun_));
  if (!folder) return folder.error();
  return Coming{key, *folder, (fs::path(*folder) / "coming").string()};
}

// Gives the file the name by which others know what it is. A packed file tells it by its name alone.
Result<DroppedFile> DroppedFiles::whole(const Coming& coming, const std::string& name) {
  std::ifstream file(coming.path, std::ios::binary);
  std::string first;
  std::getline(file, first);
  const bool packed = first.starts_with(gzip_magic);
  const auto kind = packed ? "" : text_in(member_in(first, "kind"));
  if (!packed && kind != "run" && kind != "trace")
    return Error{"", "this is no run log and no trace; expected a file like NAME.run.jsonl or NAME.trace.jsonl"};
  DroppedFile done{coming.folder, "", stem_of(name),
                   packed ? name.find(".trace.") != std::string::npos : kind == "trace"};
  done.path = (fs::path(done.folder) / fmt::format("{}.{}.jsonl{}", done.name, done.is_trace ? "trace" : "run",
                                                   packed ? gzip_ending : std::string_view()))
                  .string();
  std::error_code problem;
  fs::rename(coming.path, done.path, problem);
  if (problem) return Error{"", "the file cannot be kept: " + problem.message()};
  return done;
}

}  // namespace continua
