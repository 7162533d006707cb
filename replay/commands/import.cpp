#include "continua/replay/commands/import.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <map>

#include "continua/core/replaced_file.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/knowledge_files/named_machine.h"
#include "continua/machine_file/machine_parameters.h"
#include "continua/replay/commands/import_annotations.h"
#include "continua/replay/mcap/mcap_import.h"
#include "continua/replay/mcap/mcap_reader.h"
#include "continua/replay/recogniser/recogniser_import.h"
#include "continua/replay/recogniser/recogniser_output.h"
#include "continua/replay/trace/session_import.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t notes_shown = 20;

struct Counts {
  std::size_t traces = 0, events = 0, inputs = 0, observed = 0, notes = 0, guessed = 0;
};

void count(const Trace& trace, Counts& counts) {
  ++counts.traces;
  counts.events += trace.events.size();
  counts.notes += trace.notes.size();
  for (const auto& event : trace.events) {
    counts.inputs += std::holds_alternative<InputEvent>(event.what);
    counts.observed += std::holds_alternative<Observed>(event.what);
  }
}

void print_notes(const Trace& trace) {
  for (std::size_t i = 0; i < std::min(trace.notes.size(), notes_shown); ++i)
    put(stderr, printable(sentence_of(trace, trace.notes[i])) + "\n");
  if (trace.notes.size() > notes_shown)
    put(stderr, fmt::format("{}: {} more notes\n", trace.name, trace.notes.size() - notes_shown));
}

// Which trace each file becomes; an error if two would be the same or an input would be overwritten.
Result<std::vector<std::string>> traces_of(const ImportOptions& options) {
  if (options.output == "-" && options.logs.size() > 1)
    return Error{"-", "takes one trace; expected a folder for several files"};
  const bool folder = options.logs.size() > 1 || fs::is_directory(options.output) || options.output.ends_with('/');
  std::error_code problem;
  if (folder) fs::create_directories(options.output, problem);
  if (problem || (folder && !fs::is_directory(options.output)))
    return Error{options.output, "is no folder and cannot become one; several files need a folder"};
  std::vector<std::string> outputs;
  std::map<std::string, std::string> log_of;
  for (const auto& log : options.logs) {
    const auto output =
        folder ? (fs::path(options.output) / fs::path(log).stem()).string() + ".trace.jsonl" : options.output;
    const auto [other, fresh] = log_of.emplace(output, log);
    if (!fresh) return Error{log, fmt::format("would be written to {}, as would {}", output, other->second)};
    outputs.push_back(output);
  }
  if (auto over = not_an_input(outputs, options.logs)) return *std::move(over);
  return outputs;
}

// The trace of a session log, with the values that the machine's parameters had when it was recorded.
Result<Trace> import_log(const std::string& path) {
  const auto machine = load_named_machine(imported_machine, "");
  if (!machine) return machine.error();
  auto trace = import_session(path);
  if (!trace) return trace;
  if (const auto& recorded = trace->header.recorded; !recorded.empty())
    trace->header.parameters = parameter_values_at(**machine, recorded);
  else
    trace->notes.push_back({1, "the name does not tell when it was recorded; the machine's present rules count"});
  return trace;
}

Result<Trace> import_mcap(const std::string& path, const std::string& frame) {
  std::ifstream file(path, std::ios::binary);
  if (file.peek() == std::ifstream::traits_type::eof())
    if (const auto text = read_file(path); !text) return text.error();
  file.clear();
  return trace_of_mcap(file, path, frame);
}

// The trace of any file. A map of tiers that had to be guessed is shown.
Result<Trace> import_file(const std::string& path, const ImportOptions& options, Counts& counts) {
  if (is_mcap_file(path)) return import_mcap(path, options.frame);
  if (!is_annotation_file(path)) return import_log(path);
  std::string guessed;
  auto trace = import_annotations(path, options.tiers, guessed);
  counts.guessed += !guessed.empty();
  put(options.output == "-" ? stderr : stdout, printable(guessed));
  return trace;
}

// One trace of all files.
int import_recognisers(const ImportOptions& options) {
  const auto fail = [](const Error& error) {
    report(error);
    return exit_impossible;
  };
  if (const auto problem = not_an_input({options.output}, options.logs)) return fail(*problem);
  const auto camera = named_camera(options.camera);
  if (!camera) return fail(camera.error());
  const auto data = find_data_paths();
  const auto trace = trace_of_recognisers(
      options.logs, options.from,
      {.name = {}, .untimed = false, .camera = *camera, .knowledge = data ? data->knowledge.string() : ""});
  if (!trace) return fail(trace.error());
  if (const auto problem = write_file(options.output, write_trace(*trace))) return fail(*problem);
  fmt::print(options.output == "-" ? stderr : stdout, "imported {}: {}\n", counted(options.logs.size(), "file"),
             counted(trace->events.size(), "event"));
  return exit_done;
}

}  // namespace

int run_import(const ImportOptions& options) {
  if (!options.from.empty()) return import_recognisers(options);
  const auto outputs = traces_of(options);
  if (!outputs) return report(outputs.error()), exit_impossible;
  Counts counts;
  int status = exit_done;
  for (std::size_t i = 0; i < options.logs.size(); ++i) {
    const auto trace = import_file(options.logs[i], options, counts);
    if (!trace) {
      report(trace.error());
      status = exit_impossible;
      continue;
    }
    print_notes(*trace);
    if (const auto problem = write_file(outputs.value()[i], write_trace(*trace))) {
      report(*problem);
      status = exit_impossible;
      continue;
    }
    count(*trace, counts);
  }
  if (counts.traces > 0)
    fmt::print(options.output == "-" || counts.guessed > 0 ? stderr : stdout, "imported {}: {} ({}, {} observed), {}\n",
               counted(counts.traces, "file"), counted(counts.events, "event"), counted(counts.inputs, "input"),
               counts.observed, counted(counts.notes, "note"));
  return status;
}

void describe_import(CLI::App& command, ImportOptions& options) {
  command
      .add_option("FILE", options.logs,
                  "session logs (.txt), annotations of ELAN (.eaf) or Praat (.TextGrid), MCAP files")
      ->required();
  command.add_option("-o,--output", options.output, "the trace, '-', or a folder; a folder for several files")
      ->required();
  command.add_option(
      "--tiers", options.tiers,
      "a map that says how tiers of annotations are used; without one it is guessed from their names, and "
      "printed");
  command
      .add_option("--frame", options.frame,
                  "of MCAP files: the frame of the table in transforms, with z up and x to the human's right")
      ->capture_default_str();
  std::vector<std::string> formats;
  std::string described =
      "the files are a recogniser's; all make one trace, in order of time. A format for each file, or one for all";
  for (const auto& format : recogniser_formats()) {
    formats.emplace_back(format.name);
    described += fmt::format("; {}: {}", format.name, format.what);
  }
  command.add_option("--from", options.from, described)->check(CLI::IsMember(formats))->allow_extra_args(false);
  command.add_option("--camera", options.camera,
                     "where the recognisers' camera is (RECOGNISERS.md): hands become pointing rays");
  command.footer(
      "Examples: continua import logs/*.txt -o traces/pilot\n"
      "          continua import talk.eaf -o talk.trace.jsonl > talk.tiers.json\n"
      "          continua import talk.eaf --tiers talk.tiers.json -o talk.trace.jsonl\n"
      "          continua import bag.mcap --frame table -o talk.trace.jsonl\n"
      "          continua import speech.json hands.jsonl --from whisper --from mediapipe -o talk.trace.jsonl");
}

}  // namespace continua
