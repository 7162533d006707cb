#include "replay/commands/export.h"

#include <CLI/CLI.hpp>
#include <array>
#include <fstream>
#include <iostream>

#include "replay/exporters/json.h"

namespace continua {
namespace {

// An exporter is a function and a row.
struct Exporter {
  const char* format;
  const char* what;
  Outcome (*write)(const RunIndex& run, std::ostream& out);
};
constexpr std::array exporters = {
    Exporter{"json", "one document, every stack snapshot expanded",
             [](const RunIndex& run, std::ostream& out) { return export_json(run, out); }},
};

}  // namespace

int run_export(const ExportOptions& options) {
  const auto exporter =
      std::find_if(exporters.begin(), exporters.end(), [&](const auto& one) { return one.format == options.format; });
  const auto run = RunIndex::open(options.run);
  if (!run) return report(run.error()), exit_impossible;
  Outcome problem;
  if (options.output == "-") {
    problem = exporter->write(*run, std::cout);
  } else {
    std::ofstream file(options.output, std::ios::binary);
    problem = file ? exporter->write(*run, file) : Error{options.output, "cannot be written; expected a writable file"};
    file.close();
    if (!problem && !file) problem = Error{options.output, "could not be written to its end"};
  }
  if (problem) return report(*problem), exit_impossible;
  return exit_done;
}

void add_export_command(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("export", "Write a run in another format");
  auto options = std::make_shared<ExportOptions>();
  command->add_option("RUN", options->run, "a run log (.run.jsonl)")->required();
  std::vector<std::string> formats;
  std::string described;
  for (const auto& one : exporters) {
    formats.emplace_back(one.format);
    described += std::string(described.empty() ? "" : "; ") + one.format + ": " + one.what;
  }
  command->add_option("--to", options->format, described)->required()->check(CLI::IsMember(formats));
  command->add_option("-o,--output", options->output, "a file, or '-'");
  command->footer("Example: continua export talk.run.jsonl --to json -o talk.json");
  command->callback([options, &run] { run = [options] { return run_export(*options); }; });
}

}  // namespace continua
