#include "continua/replay/commands/export.h"

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <iostream>

#include "continua/core/replaced_file.h"
#include "continua/core/scratch_space.h"
#include "continua/replay/annotation/cues.h"
#include "continua/replay/annotation/eaf.h"
#include "continua/replay/annotation/textgrid.h"
#include "continua/replay/commands/export_annotations.h"
#include "continua/replay/commands/replayed_run.h"
#include "continua/replay/commands/setting_options.h"
#include "continua/replay/export/chrome.h"
#include "continua/replay/export/csv.h"
#include "continua/replay/export/graph_dot.h"
#include "continua/replay/export/graph_part.h"
#include "continua/replay/export/json.h"
#include "continua/replay/inspector/page_file.h"
#include "continua/replay/inspector/site_files.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/mcap/run_channels.h"
#include "continua/replay/terminal/progress.h"

namespace continua {
namespace {

Result<StateGraph> wanted_graph(const RunIndex& run, const ExportOptions& options) {
  const auto graph = state_graph_of(run);
  if (!graph) return graph;
  return part_with_states(options.only_visited ? visited_part(*graph) : *graph, options.picture.states);
}

Outcome export_dot(const RunIndex& run, const ExportOptions& options, std::ostream& out) {
  const auto graph = wanted_graph(run, options);
  if (!graph) return graph.error();
  out << dot_of(*graph);
  return std::nullopt;
}

Outcome export_svg(const RunIndex& run, const ExportOptions& options, std::ostream& out) {
  const auto graph = wanted_graph(run, options);
  if (!graph) return graph.error();
  const auto picture = picture_of(*graph, options.picture);
  if (!picture) return picture.error();
  out << *picture;
  return std::nullopt;
}

// An exporter without options.
template <auto write_it>
Outcome plainly(const RunIndex& run, const ExportOptions&, std::ostream& out) {
  return write_it(run, out);
}

Outcome export_html(const ExportOptions& options, std::ostream& out) {
  Progress progress(1);
  const auto folder = std::filesystem::path(options.output).parent_path().string();
  const auto problem = write_page(options.runs.front(), out, [&](double done) { progress.show(0, done); },
                                  {options.embed_media, folder});
  progress.clear();
  return problem;
}

Outcome export_log(const RunIndex& run, std::ostream& out) {
  const auto log = source_of_log(run.path());
  if (!log) return log.error();
  return read_pieces(**log, run.path(), [&](std::string_view piece) { out << piece; });
}

constexpr auto site_format = "site";  // of many runs: its row has no function

Outcome export_channels(const RunIndex& run, std::ostream& out) {
  const auto notes = notes_on(run);
  if (!notes) return notes.error();
  const auto header = trace_header_of(run);
  if (!header) return header.error();
  return export_mcap(run, *notes, *header, out);
}

// An exporter is a function and a row.
struct Exporter {
  const char* format;
  const char* what;
  Outcome (*write)(const RunIndex& run, const ExportOptions& options, std::ostream& out);  // null: a page
  std::string (*annotate)(const Annotations& annotations) = nullptr;  // instead of `write`; of a trace, too
};
constexpr std::array exporters = {
    Exporter{"json", "one document, every stack snapshot expanded",
             [](const RunIndex& run, const ExportOptions&, std::ostream& out) { return export_json(run, out); }},
    Exporter{"dot", "the state graph with what the run visited, for Graphviz", export_dot},
    Exporter{"svg", "the same as a picture", export_svg},
    Exporter{"csv", "a table: a row a record, a column for all that records have", plainly<export_csv>},
    Exporter{"chrome", "trace events on a time line, for Perfetto, chrome://tracing and speedscope",
             plainly<export_chrome>},
    Exporter{"jsonl", "the log with its documents in it, byte for byte as a whole log was written",
             plainly<export_log>},
    Exporter{"mcap", "channels of messages for Foxglove and ROS 2, with the log attached", plainly<export_channels>},
    Exporter{"html", "the inspector's page with this run in it, one file that opens offline", nullptr},
    Exporter{"eaf", "annotations for ELAN; also of a trace, as the next three", nullptr, eaf_of},
    Exporter{"textgrid", "annotations for Praat", nullptr, textgrid_of},
    Exporter{"vtt", "words and gestures as subtitles, WebVTT", nullptr, vtt_of},
    Exporter{"srt", "the same as SubRip", nullptr, srt_of},
    Exporter{site_format, "the inspector with many runs in it, a folder of files that opens offline", nullptr},
};

Outcome export_annotations(const Exporter& exporter, const ExportOptions& options, std::ostream& out) {
  const auto annotations = annotations_of_file(options.runs.front(), options.media, options.output);
  if (!annotations) return annotations.error();
  out << exporter.annotate(*annotations);
  return out ? Outcome() : Error{options.runs.front(), "the export could not be written"};
}

Outcome export_run(const Exporter& exporter, const ExportOptions& options, std::ostream& out) {
  if (!exporter.write) return export_html(options, out);
  const auto run = RunIndex::open(options.runs.front());
  if (!run) return run.error();
  return exporter.write(*run, options, out);
}

Outcome write(const Exporter& exporter, const ExportOptions& options, std::ostream& out) {
  const auto& input = options.runs.front();
  const bool changed = !options.replay.settings.empty();
  const bool trace = is_trace_file(input);
  if (changed && !trace) return Error{"--set", fmt::format("changes a replay; {} is a run; expected its trace", input)};
  if (exporter.annotate && !changed) return export_annotations(exporter, options, out);
  if (!trace) return export_run(exporter, options, out);
  const auto space = ScratchSpace::make();
  if (!space) return space.error();
  const auto run = replayed_run(input, options.replay, space->path());
  if (!run) return run.error();
  auto of_run = options;
  of_run.runs = {*run};
  return exporter.annotate ? export_annotations(exporter, of_run, out) : export_run(exporter, of_run, out);
}

Outcome written(const Exporter& exporter, const ExportOptions& options) {
  if (auto problem = not_an_input({options.output}, {options.runs.front()})) return problem;
  ReplacedFile file(options.output);
  if (auto problem = write(exporter, options, file.stream())) return problem;
  return file.commit();
}

Outcome written_site(const ExportOptions& options) {
  if (options.output == "-") return Error{"-o", "is missing; expected a folder for the site"};
  if (!options.replay.settings.empty()) return Error{"--set", "changes a replay; --to site shows runs as they are"};
  SiteRequest request{options.runs};
  for (std::size_t i = 0; i + 1 < options.pairs.size(); i += 2)
    request.pairs.push_back({options.pairs[i], options.pairs[i + 1]});
  Progress progress(1);
  const auto written = write_site(request, options.output, [&](double done) { progress.show(0, done); });
  progress.clear();
  if (!written) return written.error();
  fmt::print("{}, {} -> {}\n", counted(written->runs, "run"), counted(written->comparisons, "comparison"),
             printable_line(options.output + "/index.html"));
  return std::nullopt;
}

Outcome exported(const ExportOptions& options) {
  if (options.format == site_format) return written_site(options);
  if (options.runs.size() != 1) return Error{options.runs[1], "found a second run; expected one, or --to site"};
  if (!options.pairs.empty()) return Error{"--compare", "is of --to site alone"};
  const bool is_graph = options.format == "svg" || options.format == "dot";
  if (!is_graph && !options.picture.states.empty()) return Error{"--states", "is of --to svg and dot alone"};
  if (!is_graph && options.only_visited) return Error{"--visited", "is of --to svg and dot alone"};
  if (options.format != "svg" && !options.picture.width.empty()) return Error{"--width", "is of --to svg alone"};
  const auto exporter =
      std::find_if(exporters.begin(), exporters.end(), [&](const auto& one) { return one.format == options.format; });
  return options.output == "-" ? write(*exporter, options, std::cout) : written(*exporter, options);
}

}  // namespace

int run_export(const ExportOptions& options) {
  const auto problem = exported(options);
  if (problem) return report(*problem), exit_impossible;
  return exit_done;
}

void describe_export(CLI::App& command, ExportOptions& options) {
  command
      .add_option("RUN", options.runs,
                  "a run log (.run.jsonl, .run.jsonl.gz); or a trace, which is replayed, except that annotations are "
                  "made of a trace itself; for a site run logs, or folders of them")
      ->required();
  std::vector<std::string> formats;
  std::string described;
  for (const auto& one : exporters) {
    formats.emplace_back(one.format);
    described += std::string(described.empty() ? "" : "; ") + one.format + ": " + one.what;
  }
  command.add_option("--to", options.format, described)->required()->check(CLI::IsMember(formats));
  command.add_option("-o,--output", options.output, "a file, or '-'; of a site a folder");
  command
      .add_option("--media", options.media, "recordings that the annotations are about, for ELAN; also several times")
      ->allow_extra_args(false);
  command
      .add_option("--compare", options.pairs,
                  "A B: two runs that a site compares, also several times; if left out, each run with the next of the "
                  "same trace, in order of names")
      ->type_size(2);
  command.add_flag("--embed-media", options.embed_media,
                   "puts the recordings of the run's trace into the page of html, which otherwise links them");
  add_set_option(command, options.replay.settings);
  command.add_flag_callback(
      "--no-physics", [&options] { options.replay.physics = false; },
      "a trace is replayed in the kinematic world, in which acts succeed at once");
  add_graph_options(command, options.picture);
  command.add_flag("--visited", options.only_visited,
                   "of svg and dot, the states and arrows alone that the run visited");
  command.footer(
      "Examples: continua export talk.run.jsonl --to json -o talk.json\n"
      "          continua export talk.run.jsonl --to svg --visited --width 85 -o talk.svg\n"
      "          continua export talk.run.jsonl --to csv -o talk.csv\n"
      "          continua export talk.run.jsonl --to chrome -o talk.trace.json\n"
      "          continua export runs/talk.run.jsonl --to jsonl -o talk.run.jsonl\n"
      "          continua export talk.run.jsonl --to mcap -o talk.mcap\n"
      "          continua export talk.run.jsonl --to html -o talk.html\n"
      "          continua export talk.trace.jsonl --set surer_by=0.1 --to html -o talk.html\n"
      "          continua export talk.run.jsonl --to eaf --media talk.mp4 -o talk.eaf\n"
      "          continua export runs --to site -o site");
}

}  // namespace continua
