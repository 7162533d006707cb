#include "continua/replay/live/live_trace.h"

#include <filesystem>
#include <utility>

namespace continua {
namespace {

namespace fs = std::filesystem;

// A scene or machine that is named by its path from the trace, as it is from another folder.
std::string from_other_folder(const std::string& name, const fs::path& from, const fs::path& to) {
  std::error_code problem;
  if (!fs::is_regular_file(from / name, problem)) return name;
  const auto path = fs::proximate(from / name, to, problem);
  return problem ? name : path.string();
}

}  // namespace

Result<Trace> read_so_far(const std::string& path) {
  auto text = read_file(path);
  if (!text) return text.error();
  text->resize(text->rfind('\n') == std::string::npos ? 0 : text->rfind('\n') + 1);
  return read_trace_text(*text, path);
}

void move_header(TraceHeader& header, const std::string& path, const std::string& folder) {
  const auto from = fs::path(path).parent_path();
  for (auto* file : {&header.scene, &header.machine}) *file = from_other_folder(*file, from, folder);
  if (auto& json = header.json; json.is_object() && json.contains("media"))
    for (auto& one : json["media"]) one["file"] = from_other_folder(one.value("file", ""), from, folder);
}

Result<SessionBefore> read_before(const std::string& path, const std::string& folder) {
  auto trace = read_so_far(path);
  if (!trace) return trace.error();
  SessionBefore before{std::move(trace->header), {}};
  move_header(before.header, path, folder);
  std::size_t line = 2;
  for (auto& event : trace->events) {
    const auto t = event.t;
    if (std::holds_alternative<End>(event.what)) {
      before.events.push_back({t, {}, ""});
      break;
    }
    event.line = line++;
    auto text = write_event(event);
    before.events.push_back({t, std::move(event), std::move(text)});
  }
  return before;
}

}  // namespace continua
