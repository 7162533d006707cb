#include "continua/replay/media/run_media.h"

#include <filesystem>
#include <fstream>

#include "continua/core/gzip_name.h"
#include "continua/core/gzip_text.h"
#include "continua/replay/log/run_brief.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

// The header of a trace; null if the file has none.
Json header_in(const fs::path& path) {
  std::string line;
  if (is_gzip_name(path.string())) {
    const auto text = read_text(path.string());
    if (text) line = text->substr(0, text->find('\n'));
  } else {
    std::ifstream file(path, std::ios::binary);
    std::getline(file, line);
  }
  const auto json = LocatedJson::parse(line, path.string());
  return json && text_of(json->root(), "kind") == "trace" ? json->root() : Json();
}

}  // namespace

RunMedia media_of_run(const RunIndex& run, const std::vector<TracePlace>& places) {
  const auto& record = run.header();
  if (!record) return {};
  const auto name = text_of(member_of(*record, "trace"), "name");
  // A log may come from anybody: its trace is a name, not a way to elsewhere.
  if (name.empty() || fs::path(name).filename() != name) return {};
  for (const auto& [folder, within] : places)
    for (const auto* ending : {"", ".gz"}) {
      const auto path = fs::path(folder) / (name + ending);
      std::error_code problem;
      if (!fs::is_regular_file(path, problem)) continue;
      return {media_in(header_in(path)), folder, within};
    }
  return {};
}

}  // namespace continua
