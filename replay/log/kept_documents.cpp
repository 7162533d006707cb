#include "continua/replay/log/kept_documents.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/core/located_json.h"
#include "continua/core/replaced_file.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/log_file.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t shortest_document = 512;  // shorter members are hardly longer than what would stand for them
constexpr std::size_t longest_document = std::size_t{64} << 20;
constexpr std::size_t digits = 32;  // of a digest
constexpr std::string_view folder_name = "documents", document_ending = ".json", sign = "\"kept\"";

// A member of the header, or of an object in the header.
struct Place {
  std::string_view object, member;
  bool operator==(const Place&) const = default;
  std::string text() const { return fmt::format("{}{}{}", object, object.empty() ? "" : ".", member); }
};

// The members that may be kept; `what_if` has them as the header has.
constexpr std::array places{Place{"machine", "document"}, Place{"phrases", "document"}, Place{"", "knowledge"},
                            Place{"", "graph"},           Place{"scene", "mjcf"},       Place{"scene", "geoms"},
                            Place{"scene", "bodies"}};

struct Found {
  Place place;
  std::string_view value;  // within the header
};

// The places in `text`, the header or an object in it. False if it is not one whole object.
bool find_in(std::string_view text, std::string_view object, std::vector<Found>& found) {
  return scan_members(text, [&](std::string_view key, std::string_view value) {
    const auto same = std::find(places.begin(), places.end(), Place{object, key});
    if (same != places.end()) found.push_back({*same, value});
    const auto inner = std::find_if(places.begin(), places.end(), [&](const Place& one) { return one.object == key; });
    if (object.empty() && !key.empty() && inner != places.end()) find_in(value, inner->object, found);
  });
}

// All that may be kept, in the order of the header. None if the header is not one whole object.
std::vector<Found> find_places(std::string_view header) {
  std::vector<Found> found;
  if (!find_in(header, "", found)) return {};
  if (header.find("\"what_if\"") == header.npos) return found;
  find_in(member_in(header, "what_if"), "", found);
  std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.value.data() < b.value.data(); });
  return found;
}

bool is_digest(std::string_view text) {
  return text.size() == digits &&
         std::all_of(text.begin(), text.end(), [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

// The text in {"kept": TEXT}; nothing for any other value.
std::optional<std::string_view> referred_to(std::string_view value) {
  std::optional<std::string_view> text;
  std::size_t members = 0;
  scan_members(value, [&](std::string_view key, std::string_view inner) {
    ++members;
    if (key == "kept" && inner.size() >= 2 && inner.front() == '"') text = inner.substr(1, inner.size() - 2);
  });
  return members == 1 ? text : std::nullopt;
}

// The folders in which a log's documents may be, the nearest first. A link leads to the log itself.
std::vector<fs::path> folders_above(const std::string& path) {
  std::error_code unknown;
  auto real = fs::weakly_canonical(path, unknown);
  if (unknown) real = fs::absolute(path, unknown).lexically_normal();
  std::vector<fs::path> folders;
  for (auto folder = real.parent_path(); !folder.empty(); folder = folder.parent_path()) {
    folders.push_back(folder / folder_name);
    if (folder == folder.parent_path()) break;
  }
  return folders;
}

Result<std::string> read_document(const std::string& digest, const std::string& of, const std::string& path) {
  const auto folders = folders_above(path);
  for (const auto& folder : folders) {
    const auto file = (folder / (digest + std::string(document_ending))).string();
    std::error_code unknown;
    if (!fs::is_regular_file(file, unknown)) continue;
    if (fs::file_size(file, unknown) > longest_document)
      return Error{file,
                   fmt::format("is longer than {} bytes; expected a document that a run log keeps", longest_document)};
    auto text = read_file(file);
    if (!text) return text.error();
    if (auto problem = kept_document_problem(*text, file)) return *std::move(problem);
    return text;
  }
  return Error{path + ":1",
               fmt::format("`{}` is kept in a file of its own, and there is no {}/{}{} in {} or in a folder above it; "
                           "expected the folder {} that was written along with the run (continua export RUN --to jsonl "
                           "writes a run that needs none)",
                           of, folder_name, digest, document_ending,
                           folders.empty() ? std::string(".") : folders.front().parent_path().string(), folder_name)};
}

bool has_document_name(const fs::path& file) {
  return file.extension() == document_ending && is_digest(file.stem().string());
}

bool is_hidden(const fs::path& file) { return file.filename().string().starts_with('.'); }

}  // namespace

LeanHeader without_documents(std::string_view header) {
  LeanHeader lean;
  std::size_t at = 0;
  for (const auto& [place, value] : find_places(header)) {
    if (value.size() < shortest_document) continue;
    const auto from = static_cast<std::size_t>(value.data() - header.data());
    const auto name = digest(value);
    lean.line.append(header.substr(at, from - at)).append(fmt::format("{{{}:\"{}\"}}", sign, name));
    lean.documents.emplace(name, value);
    at = from + value.size();
  }
  lean.line.append(header.substr(at));
  return lean;
}

Result<std::string> with_documents(std::string_view header, const std::string& path) {
  if (header.find(sign) == header.npos) return std::string(header);
  std::string whole;
  std::size_t at = 0;
  for (const auto& [place, value] : find_places(header)) {
    const auto digest = referred_to(value);
    if (!digest) continue;
    if (!is_digest(*digest))
      return Error{path + ":1", fmt::format("`{}` is kept as {}; expected a digest of {} digits 0-9 and a-f",
                                            place.text(), in_quotes(*digest), digits)};
    const auto document = read_document(std::string(*digest), place.text(), path);
    if (!document) return document.error();
    const auto from = static_cast<std::size_t>(value.data() - header.data());
    whole.append(header.substr(at, from - at)).append(*document);
    at = from + value.size();
  }
  return whole.append(header.substr(at));
}

bool is_kept_document(const std::string& path) {
  const auto file = fs::path(path);
  return has_document_name(file) && fs::absolute(file).lexically_normal().parent_path().filename() == folder_name;
}

Outcome kept_document_problem(std::string_view text, const std::string& path) {
  const auto stated = fs::path(path).stem().string(), found = digest(text);
  if (found == stated) return std::nullopt;
  return Error{path,
               fmt::format("is not the document that it was: its digest is {}, its name says {}; expected the file "
                           "that was written along with the run",
                           found, stated)};
}

std::optional<std::string> documents_above(const std::string& path) {
  for (const auto& folder : folders_above(path)) {
    std::error_code unknown;
    fs::directory_iterator files(folder, unknown);
    if (!unknown && std::all_of(begin(files), end(files), [](const fs::directory_entry& file) {
          return has_document_name(file.path()) || is_hidden(file.path());
        }))
      return folder.string();
  }
  return std::nullopt;
}

Outcome keep_documents(const LeanHeader& header, const std::string& folder) {
  if (header.documents.empty()) return std::nullopt;
  std::error_code problem;
  fs::create_directories(folder, problem);
  if (problem) return Error{folder, "cannot be made: " + problem.message()};
  for (const auto& [name, text] : header.documents) {
    const auto file = (fs::path(folder) / (name + std::string(document_ending))).string();
    if (fs::is_regular_file(file, problem))
      if (const auto there = read_file(file); there && *there == text) continue;
    if (auto unwritten = replace_file(file, text, ReplacedFile::Links::replace)) return unwritten;
  }
  return std::nullopt;
}

Result<std::size_t> remove_unused_documents(const std::string& folder) {
  std::error_code problem;
  std::vector<fs::path> documents;
  for (fs::directory_iterator file(folder, problem), end; !problem && file != end; file.increment(problem))
    if (has_document_name(file->path())) documents.push_back(file->path());
  const auto around = fs::absolute(folder).lexically_normal().parent_path();
  for (fs::recursive_directory_iterator file(around, problem), end; !problem && file != end; file.increment(problem)) {
    if (!is_run_log_name(file->path().string()) || !file->is_regular_file()) continue;
    const auto header = first_line(file->path().string());
    if (!header) return header.error();
    for (const auto& [place, value] : find_places(*header))
      std::erase_if(documents,
                    [digest = referred_to(value)](const auto& one) { return digest == one.stem().string(); });
  }
  if (problem) return Error{around.string(), "cannot be read to its end: " + problem.message()};
  for (const auto& one : documents) fs::remove(one, problem);
  return documents.size();
}

}  // namespace continua
