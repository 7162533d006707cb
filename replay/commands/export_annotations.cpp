#include "continua/replay/commands/export_annotations.h"

#include <filesystem>
#include <fstream>

#include "continua/replay/inspector/run_notes.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {
namespace {

// The run's trace, if it lies beside the run and has not changed.
std::optional<Trace> trace_beside(const RunIndex& run) {
  const auto& header = run.header();
  if (!header) return std::nullopt;
  const auto& named = member_of(*header, "trace");
  const auto path = std::filesystem::path(run.path()).parent_path() / text_of(named, "name");
  auto trace = read_trace(path.string());
  if (!trace || trace->digest != text_of(named, "digest")) return std::nullopt;
  return *std::move(trace);
}

Result<Annotations> annotations_of_run_at(const std::string& path) {
  const auto run = RunIndex::open(path);
  if (!run) return run.error();
  const auto notes = notes_on(*run);
  if (!notes) return notes.error();
  auto annotations = annotations_of_run(*run, *notes);
  if (!annotations) return annotations;
  if (auto trace = trace_beside(*run)) {
    trace->events.clear();
    auto own = annotations_of_trace(*trace);
    annotations->header = std::move(own.header);
    annotations->recorded = std::move(own.recorded);
    annotations->media = std::move(own.media);
  }
  return annotations;
}

Result<Annotations> annotations_of_trace_at(const std::string& path) {
  const auto trace = read_trace(path);
  if (!trace) return trace.error();
  return annotations_of_trace(*trace);
}

// A recording's path, which starts at the folder of `input`, as it starts at that of `output`.
std::string from_folder_of(const std::string& output, const std::string& input, const std::string& file) {
  namespace fs = std::filesystem;
  if (output == "-" || fs::path(file).is_absolute()) return file;
  std::error_code problem;
  const auto folder = fs::absolute(output, problem).parent_path();
  const auto found = fs::proximate(fs::absolute(input, problem).parent_path() / file, folder, problem);
  return problem ? file : found.generic_string();
}

}  // namespace

Result<std::vector<NoteOnRun>> notes_on(const RunIndex& run) {
  const auto read = read_notes(notes_path(run.path()));
  if (!read) return read.error();
  std::vector<NoteOnRun> notes;
  for (const auto& note : read->notes)
    if (const auto to = note.to.value_or(note.n); note.n < run.size() && to < run.size())
      notes.push_back({note.n, to, note.text});
  return notes;
}

Result<std::string> trace_header_of(const RunIndex& run) {
  if (const auto trace = trace_beside(run)) return write_header(trace->header);
  const auto& header = run.header();
  if (!header) return header.error();
  return trace_header_of_run(*header);
}

bool is_trace_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string line;
  while (std::getline(file, line) && line.find_first_not_of(" \t\r") == std::string::npos) continue;
  const auto first = LocatedJson::parse(line, path);
  return first && text_of(first->root(), "kind") == "trace";
}

Result<Annotations> annotations_of_file(const std::string& path, const std::vector<std::string>& media,
                                        const std::string& output) {
  auto annotations = is_trace_file(path) ? annotations_of_trace_at(path) : annotations_of_run_at(path);
  if (!annotations) return annotations;
  for (auto& one : annotations->media) one.file = from_folder_of(output, path, one.file);
  for (const auto& file : media) annotations->media.push_back({file, 0});
  return annotations;
}

}  // namespace continua
