#include "continua/replay/commands/replay.h"

#include "continua/core/located_json.h"
#include "continua/core/replaced_file.h"
#include "continua/core/several_at_once.h"
#include "continua/replay/commands/instant_option.h"
#include "continua/replay/commands/setting_options.h"
#include "continua/replay/log/run_log_file.h"
#include "continua/replay/session/outside_choice.h"
#include "continua/replay/session/shelf.h"
#include "continua/replay/terminal/progress.h"
#include "continua/replay/terminal/shell_word.h"
#include "continua/replay/trace/trace_name.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <map>
#include <mutex>
#include <set>
#include <tuple>

namespace continua {
namespace fs = std::filesystem;
namespace {

constexpr int most_branches = 100'000;  // each takes some kilobytes

// The name of a run that was given none; a run with changes must not take the place of the run itself.
std::string run_name(const std::string& trace, const ReplayCommandOptions& options) {
  return fmt::format("{}{}.run.jsonl{}", trace_name(trace), options.replay.from ? ".what_if" : "",
                     options.gzip ? gzip_ending : "");
}

// The trace's run without changes, where a file of its name stands in the folder of the trace or of the output.
std::optional<std::string> original_run(const std::string& trace, const std::string& output, bool physics) {
  const auto name = trace_name(trace);
  for (const auto& folder : {fs::path(trace).parent_path(), fs::path(output).parent_path()})
    for (const std::string ending : {physics ? ".physics.run.jsonl" : ".kinematic.run.jsonl", ".run.jsonl"})
      for (const auto packed : {std::string_view(), gzip_ending}) {
        const auto path = folder / fmt::format("{}{}{}", name, ending, packed);
        std::error_code unknown;
        if (fs::is_regular_file(path, unknown) && !fs::equivalent(path, output, unknown)) return path.string();
      }
  return std::nullopt;
}

// The command to type next to see the effect of the change.
std::string comparison(const std::string& trace, const std::string& output, const ReplayOptions& options) {
  if (output == "-" || (!options.from && options.forced.empty())) return "";
  const auto original = original_run(trace, output, options.physics);
  return original ? fmt::format("; compare: continua diff {} {}", shell_word(*original), shell_word(output)) : "";
}

bool is_for_folder(const ReplayCommandOptions& options) {
  const auto& output = options.output;
  return output.empty() || options.traces.size() > 1 || output.ends_with('/') || fs::is_directory(output);
}

Result<std::vector<std::string>> runs_of(const ReplayCommandOptions& options) {
  const auto& output = options.output;
  const bool folder = is_for_folder(options);
  if (output == "-" && options.traces.size() > 1)
    return Error{"-", "takes one run log; expected a folder for several traces"};
  std::error_code problem;
  if (folder && !output.empty()) fs::create_directories(output, problem);
  if (problem || (folder && !output.empty() && !fs::is_directory(output)))
    return Error{output, "is no folder and cannot become one; several traces need a folder"};
  std::vector<std::string> outputs;
  std::map<std::string, std::string> trace_of;
  for (const auto& trace : options.traces) {
    if (fs::is_directory(trace, problem))
      return Error{trace, fmt::format("is a folder; expected traces (continua replay {0}/*.trace.jsonl -o FOLDER), or "
                                      "continua check {0}, which takes all below it",
                                      shell_word(fs::path(trace).lexically_normal().string()))};
    const auto path = folder ? (fs::path(output) / run_name(trace, options)).string() : output;
    const auto [other, fresh] = trace_of.emplace(path, trace);
    if (!fresh) return Error{trace, fmt::format("would be written to {}, as would {}", path, other->second)};
    outputs.push_back(path);
  }
  if (auto over = not_an_input(outputs, options.traces)) return *std::move(over);
  return outputs;
}

std::string line_of(const std::string& trace, const ReplaySummary& summary, const std::string& output) {
  const auto optional = [](int count, const char* noun, const char* more = "") {
    return count ? fmt::format(", {}{}", counted(static_cast<std::size_t>(count), noun), more) : std::string();
  };
  return fmt::format(
      "{}: {:.1f} s, {} inputs, {} utterances, {} of {} acts done, {} inputs refused{}{}{}{} -> {}",
      fs::path(trace).filename().string(), summary.end.seconds(), summary.inputs, summary.utterances, summary.acts_done,
      summary.acts, summary.refusals,
      summary.expectations ? fmt::format(", {} of {} expectations met", summary.expectations_met, summary.expectations)
                           : "",
      optional(summary.fragile, "fragile decision"), optional(summary.pruned, "configuration", " pruned"),
      optional(summary.problems, "problem"), output);
}

// Several replays at once, and their lines, which come out in the order of the traces.
class Batch {
 public:
  Batch(const ReplayCommandOptions& options, std::vector<std::string> outputs)
      : options_(options),
        documents_(options.output.empty() || options.whole || !is_for_folder(options)
                       ? ""
                       : (fs::path(options.output) / "documents").string()),
        outputs_(std::move(outputs)),
        items_(dealt(options.shards.shard, costs_of(options.traces))),
        lines_(items_.size()),
        progress_(items_.size()) {}

  void run() {
    several_at_once(items_.size(), jobs_at_a_time(options_.jobs, options_.replay.learned),
                    [this](std::size_t i) { one(i); });
  }

  /// After the run.
  ShardReport report() const {
    ShardReport all{"replay", options_.shards.shard, options_.traces.size(), items_, status_, {}};
    for (std::size_t i = 0; i < items_.size(); ++i) all.told.push_back(told(i));
    return all;
  }

 private:
  // The line of a trace that was replayed.
  std::string told(std::size_t index) const {
    const auto& line = *lines_[index];
    return line.empty() ? line : printable_line(line) + "\n";
  }

  // `index`: among the shard's items, as everywhere below.
  void one(std::size_t index) {
    const auto& trace = options_.traces[items_[index]];
    auto options = options_.replay;
    options.shelf = shelf_;
    options.progress = [this, index](double done) {
      const std::lock_guard lock(mutex_);
      progress_.show(index, done);
    };
    const auto& output = outputs_[items_[index]];
    auto session = Session::load(trace, std::move(options));
    if (!session) return finish(index, session.error(), output);
    if (session->warning()) warn(*session->warning());
    if (output == "-") {
      const auto summary = session->run(std::cout);
      if (!std::cout.flush()) return finish(index, Error{"standard output", "could not be written to its end"}, output);
      return finish(index, kept(*session, summary), output);
    }
    if (auto problem = not_an_input({output}, session->files())) return finish(index, *std::move(problem), output);
    RunLogFile file(output, documents_);
    if (!file.stream()) return finish(index, *file.commit(), output);
    const auto summary = session->run(file.stream());
    const auto problem = summary.stopped ? Outcome() : file.commit();
    finish(index, problem ? Result<ReplaySummary>(*problem) : kept(*session, summary), output);
  }

  // Several traces may be of one scene: its warning is told once.
  void warn(const Error& warning) {
    const std::lock_guard lock(mutex_);
    if (!warned_.insert(warning.text()).second) return;
    progress_.clear();
    report_warning(warning);
  }

  static Result<ReplaySummary> kept(const Session& session, const ReplaySummary& summary) {
    if (summary.stopped) return *summary.stopped;
    if (const auto problem = session.keep_learned()) return *problem;
    return summary;
  }

  void finish(std::size_t index, const Result<ReplaySummary>& summary, const std::string& output) {
    const std::lock_guard lock(mutex_);
    progress_.show(index, 1);
    progress_.clear();
    if (!summary) {
      continua::report(summary.error());
      status_ = exit_impossible;
      lines_[index] = "";
    } else {
      const auto& trace = options_.traces[items_[index]];
      lines_[index] = line_of(trace, *summary, output) + comparison(trace, output, options_.replay);
      if (options_.replay.from && !summary->changed)
        report_warning({trace, fmt::format("--from {}: nothing happens from then on; nothing was changed",
                                           *options_.replay.from)});
      for (const auto& [step, transition] : summary->not_forced) {
        continua::report(
            {trace, fmt::format("--force {}={}: that transition does not apply at that step", step, transition)});
        status_ = exit_impossible;
      }
      const auto& [from, with] = std::tie(options_.replay.from, options_.replay.with);
      for (const auto& unmet : summary->unmet)
        continua::report(unmet.error(!with.empty() && unmet.t >= SimTime::from_seconds(*from) ? with : trace));
      if (summary->expectations_met < summary->expectations && status_ == exit_done) status_ = exit_no;
    }
    for (; printed_ < lines_.size() && lines_[printed_]; ++printed_)
      put(output == "-" ? stderr : stdout, told(printed_));
    std::fflush(stdout);
  }

  const ReplayCommandOptions& options_;
  const std::shared_ptr<Shelf> shelf_ = std::make_shared<Shelf>();
  const std::string documents_;  // the folder for them; empty: in the logs
  std::vector<std::string> outputs_;
  const std::vector<std::size_t> items_;  // of the traces, the shard's
  std::mutex mutex_;
  std::vector<std::optional<std::string>> lines_;
  Progress progress_;
  std::set<std::string> warned_;
  std::size_t printed_ = 0;
  int status_ = exit_done;
};

// "12=ask" into the map.
void add_forced(const std::string& text, std::map<int, std::string>& forced) {
  const auto equals = text.find('=');
  int step = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + std::min(equals, text.size()), step);
  if (equals == std::string::npos || problem != std::errc() || end != text.data() + equals || step < 1)
    throw CLI::ValidationError("--force", fmt::format("found {}; expected N=TRANSITION, N from 1", in_quotes(text)));
  if (!forced.emplace(step, text.substr(equals + 1)).second)
    throw CLI::ValidationError("--force", fmt::format("step {} is forced twice", step));
}

// The option and its text, once the arguments are read.
std::shared_ptr<std::string> add_choice(CLI::App& command) {
  auto choice = std::make_shared<std::string>();
  command
      .add_option(
          "--choice", *choice,
          "which of several applicable transitions fires: likeliest, sample, unique, or all: explore; "
          "otherwise the machine's. pipe:COMMAND asks a command (replay/session/POLICY.md); run:RUN takes those "
          "that a run log has")
      ->check([](const std::string& name) {
        return parse_choice(name) || is_outside_choice(name)
                   ? std::string()
                   : fmt::format("expected {}, pipe:COMMAND or run:RUN", choice_names());
      });
  return choice;
}

constexpr const char* examples =
    "Examples: continua replay traces/pilot/*.jsonl -o runs -j 2\n"
    "          continua replay session.trace.jsonl --set surer_by=0.1 -o other.run.jsonl\n"
    "          continua replay session.trace.jsonl --force 12=ask_color -o what_if.run.jsonl\n"
    "          continua replay session.trace.jsonl --from 4.0 --machine edited.json -o what_if.run.jsonl\n"
    "          continua diff session.run.jsonl what_if.run.jsonl\n"
    "          continua replay traces/*.jsonl -o runs/ --shard 1/2 --report 1.json\n"
    "          continua replay --merge 1.json 2.json";

}  // namespace

int run_replay(const ReplayCommandOptions& options) {
  if (!options.shards.merge.empty()) {
    const auto merged = merge_shards("replay", options.shards.merge);
    if (!merged) return report(merged.error()), exit_impossible;
    for (const auto& line : merged->told) put(stdout, line);
    return merged->status;
  }
  auto outputs = runs_of(options);
  if (!outputs) return report(outputs.error()), exit_impossible;
  if (const auto problem = not_an_input({options.shards.report}, options.traces))
    return report(*problem), exit_impossible;
  Batch batch(options, std::move(*outputs));
  batch.run();
  return keep_report(options.shards, batch.report());
}

void describe_replay(CLI::App& command, ReplayCommandOptions& options) {
  command.add_option("TRACE", options.traces, "traces (.jsonl, .jsonl.gz)");
  command.add_option("-o,--output", options.output,
                     "a run log, packed if its name ends with .gz, a folder, or '-'; otherwise NAME.run.jsonl here");
  command.add_flag(
      "--whole", options.whole,
      "with a folder: each log has its machine and scene in it; otherwise these are kept once, in documents/");
  command.add_flag("--gzip", options.gzip, "where no file is named: NAME.run.jsonl.gz, which all commands read");
  command.add_option("--seed", options.replay.seed, "for draws; otherwise the trace's");
  const auto choice = add_choice(command);
  command.add_option("--branches", options.replay.most_branches, "under explore, how many configurations are kept")
      ->check(CLI::Range(1, most_branches));
  auto forced = std::make_shared<std::vector<std::string>>();
  command
      .add_option("--force", *forced,
                  "N=TRANSITION: at step N of the run, a transition record's `step`, take this transition")
      ->allow_extra_args(false);
  takes_instants(
      command.add_option("--from", options.replay.from,
                         "what if? --machine, --language, --knowledge, --choice, --seed, --force and --with count from "
                         "this instant of the run on; until then it is the trace's own run. State, slots and registers "
                         "go over by their names"))
      ->check(CLI::Range(0.0, 1e9));
  command.add_option("--with", options.replay.with,
                     "with --from: a trace, perhaps an edited copy; from then on its events happen, and its machine, "
                     "seed and perspective count. Its scene and objects must be the same");
  add_setting_options(command, options.replay);
  command.add_option("--learned", options.replay.learned,
                     "a file of what was taught: read if it exists, and written when a run has changed it");
  command.add_flag_callback(
      "--no-physics", [&options] { options.replay.physics = false; },
      "the kinematic world, in which acts succeed at once");
  auto variant = std::make_shared<std::string>();
  command
      .add_option("--variant", *variant,
                  "with --no-physics: what the trace has observed of another avatar moves the world (world), and is "
                  "where the dialogue goes on from after a difference (teacher); otherwise not (free)")
      ->check(CLI::IsMember({"free", "world", "teacher"}));
  command.add_option("-j,--jobs", options.jobs, "how many traces at a time")->check(CLI::Range(1, 256));
  add_shard_options(command, options.shards, "TRACE", "replaying");
  command.footer(examples);
  command.callback([&options, choice, forced, variant] {
    expect_items(options.traces, options.shards, "TRACE");
    options.replay.variant = parse_variant(*variant).value_or(Variant::free);
    options.replay.choice = parse_choice(*choice);
    if (is_outside_choice(*choice)) options.replay.outside = *choice;
    for (const auto& one : *forced) add_forced(one, options.replay.forced);
  });
}

}  // namespace continua
