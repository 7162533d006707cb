#include "continua/replay/commands/score.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <set>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/core/located_json.h"
#include "continua/core/replaced_file.h"
#include "continua/core/several_at_once.h"
#include "continua/replay/commands/setting_options.h"
#include "continua/replay/log/run_log_file.h"
#include "continua/replay/score/score_part.h"
#include "continua/replay/score/score_report.h"
#include "continua/replay/session/shelf.h"
#include "continua/replay/terminal/progress.h"
#include "continua/replay/trace/trace_file.h"
#include "continua/replay/trace/trace_name.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

// Where the run logs go; empty ones if they are not kept.
Result<std::vector<std::string>> runs_of(const ScoreOptions& options) {
  std::vector<std::string> runs(options.traces.size());
  if (options.output.empty()) return runs;
  std::error_code problem;
  fs::create_directories(options.output, problem);
  if (problem || !fs::is_directory(options.output, problem))
    return Error{options.output, "is no folder and cannot become one; expected a folder for the run logs"};
  std::map<std::string, std::string> trace_of;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const auto& trace = options.traces[i];
    runs[i] =
        (fs::path(options.output) / (trace_name(trace) + (options.gzip ? ".run.jsonl.gz" : ".run.jsonl"))).string();
    const auto [other, fresh] = trace_of.emplace(runs[i], trace);
    if (!fresh) return Error{trace, fmt::format("would be written to {}, as would {}", runs[i], other->second)};
  }
  if (auto over = not_an_input(runs, options.traces)) return *std::move(over);
  return runs;
}

// Scores traces, several at once.
class Scoring {
 public:
  Scoring(const ScoreOptions& options, std::vector<std::string> runs)
      : options_(options),
        runs_(std::move(runs)),
        items_(dealt(options.shards.shard, costs_of(options.traces))),
        scores_(items_.size()),
        progress_(items_.size()) {}

  void run() {
    several_at_once(items_.size(), options_.jobs, [this](std::size_t i) {
      auto score = score_of(i);
      const std::lock_guard lock(mutex_);
      scores_[i] = std::move(score);
      progress_.show(i, 1);
    });
    progress_.clear();
  }

  /// The shard's traces; reports those that cannot be used.
  ShardReport report() const {
    ShardReport all{"score", options_.shards.shard, options_.traces.size(), items_, exit_done, {}};
    for (const auto& one : scores_) {
      all.told.push_back(
          text_of_part(name_of(options_.replay.variant), one->ok() ? std::optional(**one) : std::nullopt));
      if (one->ok()) continue;
      continua::report(one->error());
      all.status = exit_impossible;
    }
    return all;
  }

 private:
  // `index`: among the shard's items.
  Result<TraceScore> score_of(std::size_t index) {
    const auto& trace = options_.traces[items_[index]];
    const auto& kept = runs_[items_[index]];
    auto options = options_.replay;
    options.shelf = shelf_;
    options.episodes = true;
    options.progress = [this, index](double done) {
      const std::lock_guard lock(mutex_);
      progress_.show(index, done);
    };
    auto session = Session::load(trace, std::move(options));
    if (!session) return session.error();
    if (session->warning()) warn(*session->warning());
    TraceScore score{trace_name(trace), trace, kept, {}, {}, {}};
    auto summary = replayed(*session, score.run);
    if (!summary) return summary.error();
    if (!session->trace().observes()) {
      warn({trace, "nothing was observed; there is nothing to compare"});
      return score;
    }
    const auto blanks = session->blanks();
    for (auto& episode : summary->episodes) score.add(std::move(episode), blanks);
    return score;
  }

  Result<ReplaySummary> replayed(Session& session, const std::string& run) const {
    if (run.empty()) {
      std::ostream nowhere(nullptr);
      return session.run(nowhere);
    }
    if (auto problem = not_an_input({run}, session.files())) return *std::move(problem);
    RunLogFile file(run, options_.whole ? "" : (fs::path(options_.output) / "documents").string());
    if (!file.stream()) return *file.commit();
    auto summary = session.run(file.stream());
    if (auto problem = file.commit()) return *std::move(problem);
    return summary;
  }

  // Several traces may be of one scene: its warning is told once.
  void warn(const Error& warning) {
    const std::lock_guard lock(mutex_);
    if (!warned_.insert(warning.text()).second) return;
    progress_.clear();
    report_warning(warning);
  }

  const ScoreOptions& options_;
  const std::shared_ptr<Shelf> shelf_ = std::make_shared<Shelf>();
  std::vector<std::string> runs_;         // of all traces
  const std::vector<std::size_t> items_;  // of the traces, the shard's
  std::mutex mutex_;
  std::vector<std::optional<Result<TraceScore>>> scores_;
  Progress progress_;
  std::set<std::string> warned_;
};

// The report that the parts give.
int tell(const std::vector<std::string>& parts, const ScoreOptions& options, int status) {
  ScoreReport score;
  for (const auto& part : parts)
    if (const auto problem = add_part(score, part)) return report(*problem), exit_impossible;
  if (score.traces.empty() && !options.json) return status;
  const auto text = options.json       ? score_json(score).dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
                    : options.markdown ? score_markdown(score)
                                       : score_text(score, options.all_misses);
  if (const auto problem = write_file("-", text)) return report(*problem), exit_impossible;
  return status;
}

}  // namespace

int run_score(const ScoreOptions& options) {
  if (!options.shards.merge.empty()) {
    const auto merged = merge_shards("score", options.shards.merge);
    if (!merged) return report(merged.error()), exit_impossible;
    return tell(merged->told, options, merged->status);
  }
  auto runs = runs_of(options);
  if (!runs) return report(runs.error()), exit_impossible;
  Scoring scoring(options, std::move(*runs));
  scoring.run();
  auto made = scoring.report();
  made.status = tell(made.told, options, made.status);
  return keep_report(options.shards, made);
}

void describe_score(CLI::App& command, ScoreOptions& options) {
  options.replay.physics = false;
  command.add_option("TRACE", options.traces, "traces (.jsonl, .jsonl.gz) with `observed` events");
  auto variant = std::make_shared<std::string>();
  command
      .add_option("--variant", *variant,
                  "how far what was observed leads the run. free (the default): not at all; world: the observed acts "
                  "move the blocks, the engine's do not; teacher: also, after a miss the engine goes on as if it had "
                  "done what was observed")
      ->check(CLI::IsMember({"free", "world", "teacher"}));
  command.add_option("-o,--output", options.output,
                     "a folder for the run logs, NAME.run.jsonl; otherwise they are not kept");
  command.add_flag("--whole", options.whole,
                   "with -o: each log has its machine and scene in it; otherwise these are kept once, in documents/");
  command.add_flag("--gzip", options.gzip, "with -o: NAME.run.jsonl.gz, which all commands read");
  auto* json = command.add_flag("--json", options.json, "one JSON document, with all misses");
  command.add_flag("--markdown", options.markdown, "the tables as Markdown")->excludes(json);
  command.add_flag("--misses", options.all_misses, "tell all misses, not the first few of each trace");
  command.add_option("--seed", options.replay.seed, "for draws; otherwise the trace's");
  add_setting_options(command, options.replay);
  command.add_option("-j,--jobs", options.jobs, "how many traces at a time")->check(CLI::Range(1, 256));
  add_shard_options(command, options.shards, "TRACE", "scoring");
  command.footer(
      "Traces are replayed in the kinematic world. replay/score/SCORE.md says what is counted.\n"
      "Exit status: 0 done, 2 a trace cannot be used (the others are scored all the same).\n"
      "Examples: continua score traces/pilot/*.jsonl -j 2\n"
      "          continua score session.trace.jsonl -o runs --misses\n"
      "          continua score traces/pilot/*.jsonl --variant teacher --json\n"
      "          continua score traces/pilot/*.jsonl --shard 1/2 --report 1.json\n"
      "          continua score --merge 1.json 2.json");
  command.callback([&options, variant] {
    expect_items(options.traces, options.shards, "TRACE");
    options.replay.variant = parse_variant(*variant).value_or(Variant::free);
  });
}

}  // namespace continua
