#include "continua/replay/commands/export.h"

#include <CLI/CLI.hpp>
#include <array>
#include <iostream>

#include "continua/core/replaced_file.h"
#include "continua/replay/annotation/cues.h"
#include "continua/replay/annotation/eaf.h"
#include "continua/replay/annotation/textgrid.h"
#include "continua/replay/commands/export_annotations.h"
#include "continua/replay/export/chrome.h"
#include "continua/replay/export/csv.h"
#include "continua/replay/export/graph_dot.h"
#include "continua/replay/export/graph_svg.h"
#include "continua/replay/export/json.h"
#include "continua/replay/inspector/page_file.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/terminal/progress.h"

namespace continua {
namespace {

Outcome export_dot(const RunIndex& run, std::ostream& out) {
  const auto graph = state_graph_of(run);
  if (!graph) return graph.error();
  out << dot_of(*graph);
  return std::nullopt;
}

Outcome export_svg(const RunIndex& run, std::ostream& out) {
  const auto graph = state_graph_of(run);
  if (!graph) return graph.error();
  const auto picture = svg_of(*graph);
  if (!picture) return picture.error();
  out << *picture;
  return std::nullopt;
}

Outcome export_html(const RunIndex& run, std::ostream& out) {
  Progress progress(1);
  const auto problem = write_page(run.path(), out, [&](double done) { progress.show(0, done); });
  progress.clear();
  return problem;
}

Outcome export_log(const RunIndex& run, std::ostream& out) {
  const auto log = source_of_log(run.path());
  if (!log) return log.error();
  return read_pieces(**log, run.path(), [&](std::string_view piece) { out << piece; });
}

// An exporter is a function and a row.
struct Exporter {
  const char* format;
  const char* what;
  Outcome (*write)(const RunIndex& run, std::ostream& out);
  std::string (*annotate)(const Annotations& annotations) = nullptr;  // instead of `write`; of a trace, too
};
constexpr std::array exporters = {
    Exporter{"json", "one document, every stack snapshot expanded",
             [](const RunIndex& run, std::ostream& out) { return export_json(run, out); }},
    Exporter{"dot", "the state graph with what the run visited, for Graphviz", export_dot},
    Exporter{"svg", "the same as a picture", export_svg},
    Exporter{"csv", "a table: a row a record, a column for all that records have", export_csv},
    Exporter{"chrome", "trace events on a time line, for Perfetto, chrome://tracing and speedscope", export_chrome},
    Exporter{"jsonl", "the log with its documents in it, byte for byte as a whole log was written", export_log},
    Exporter{"html", "the inspector's page with this run in it, one file that opens offline", export_html},
    Exporter{"eaf", "annotations for ELAN; also of a trace, as the next three", nullptr, eaf_of},
    Exporter{"textgrid", "annotations for Praat", nullptr, textgrid_of},
    Exporter{"vtt", "words and gestures as subtitles, WebVTT", nullptr, vtt_of},
    Exporter{"srt", "the same as SubRip", nullptr, srt_of},
};

Outcome export_annotations(const Exporter& exporter, const ExportOptions& options, std::ostream& out) {
  const auto annotations = annotations_of_file(options.run, options.media);
  if (!annotations) return annotations.error();
  out << exporter.annotate(*annotations);
  return out ? Outcome() : Error{options.run, "the export could not be written"};
}

Outcome export_run(const Exporter& exporter, const ExportOptions& options, std::ostream& out) {
  if (is_trace_file(options.run))
    return Error{options.run, "found a trace; expected a run log, or --to eaf, textgrid, vtt or srt"};
  const auto run = RunIndex::open(options.run);
  if (!run) return run.error();
  return exporter.write(*run, out);
}

Outcome write(const Exporter& exporter, const ExportOptions& options, std::ostream& out) {
  return exporter.annotate ? export_annotations(exporter, options, out) : export_run(exporter, options, out);
}

Outcome written(const Exporter& exporter, const ExportOptions& options) {
  if (auto problem = not_an_input(options.output, {options.run})) return problem;
  ReplacedFile file(options.output);
  if (auto problem = write(exporter, options, file.stream())) return problem;
  return file.commit();
}

}  // namespace

int run_export(const ExportOptions& options) {
  const auto exporter =
      std::find_if(exporters.begin(), exporters.end(), [&](const auto& one) { return one.format == options.format; });
  const auto problem = options.output == "-" ? write(*exporter, options, std::cout) : written(*exporter, options);
  if (problem) return report(*problem), exit_impossible;
  return exit_done;
}

void describe_export(CLI::App& command, ExportOptions& options) {
  command.add_option("RUN", options.run, "a run log (.run.jsonl, .run.jsonl.gz); for annotations also a trace")
      ->required();
  std::vector<std::string> formats;
  std::string described;
  for (const auto& one : exporters) {
    formats.emplace_back(one.format);
    described += std::string(described.empty() ? "" : "; ") + one.format + ": " + one.what;
  }
  command.add_option("--to", options.format, described)->required()->check(CLI::IsMember(formats));
  command.add_option("-o,--output", options.output, "a file, or '-'");
  command.add_option("--media", options.media,
                     "recordings that the annotations are about, for ELAN; also several times");
  command.footer(
      "Examples: continua export talk.run.jsonl --to json -o talk.json\n"
      "          continua export talk.run.jsonl --to svg -o talk.svg\n"
      "          continua export talk.run.jsonl --to csv -o talk.csv\n"
      "          continua export talk.run.jsonl --to chrome -o talk.trace.json\n"
      "          continua export runs/talk.run.jsonl --to jsonl -o talk.run.jsonl\n"
      "          continua export talk.run.jsonl --to html -o talk.html\n"
      "          continua export talk.run.jsonl --to eaf --media talk.mp4 -o talk.eaf");
}

}  // namespace continua
