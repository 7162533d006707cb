#include "continua/replay/commands/sweep.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/core/digest.h"
#include "continua/core/replaced_file.h"
#include "continua/core/several_at_once.h"
#include "continua/replay/commands/setting_options.h"
#include "continua/replay/commands/sweep_run.h"
#include "continua/replay/sweep/sweep_page.h"
#include "continua/replay/sweep/sweep_pictures.h"
#include "continua/replay/sweep/sweep_result.h"
#include "continua/replay/terminal/progress.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

std::string in_folder(const SweepOptions& options, const std::string& name) {
  return (fs::path(options.output) / name).string();
}

// The points of a shard, several at once. Each goes into a file of its own as soon as it is done: whatever ends the
// program, a point is there as a whole or not at all.
class Sweeping {
 public:
  Sweeping(const SweepOptions& options, SweepGiven given, std::vector<SweepPoint> points)
      : options_(options),
        given_(std::move(given)),
        points_(std::move(points)),
        items_(dealt(options.shards.shard, std::vector<std::uint64_t>(points_.size(), 1))),
        lines_(items_.size()),
        progress_(items_.size()) {}

  void run() {
    several_at_once(items_.size(), options_.jobs, [this](std::size_t i) { lines_[i] = one(items_[i]); });
    progress_.clear();
    if (found_ > 0) put(stderr, fmt::format("{} of {} were there already\n", found_, counted(done_, "point")));
  }

  /// After the run.
  ShardReport report() const { return {"sweep", options_.shards.shard, points_.size(), items_, status_, lines_}; }

 private:
  // The point's line; empty if there is none.
  std::string one(std::size_t index) {
    const auto& point = points_[index];
    const auto path = in_folder(options_, fmt::format("points/{}.json", digest(given_.digest + compact(point.json()))));
    auto kept = LocatedJson::read(path);
    const bool found = kept && kept->root().is_object();
    auto line = found ? Result<Json>(kept->root()) : swept(given_, point);
    if (line && !found)
      if (auto problem = replace_file(path, compact(*line) + "\n")) line = *std::move(problem);
    const std::lock_guard lock(mutex_);
    progress_.show(done_++, 1);
    found_ += found;
    if (line) {
      Json numbered{{"point", index + 1}};
      numbered.update(*line);
      return compact(numbered) + "\n";
    }
    progress_.clear();
    continua::report({line.error().where, fmt::format("{} (point {})", line.error().sentence, index + 1)});
    status_ = exit_impossible;
    return "";
  }

  const SweepOptions& options_;
  const SweepGiven given_;
  const std::vector<SweepPoint> points_;
  const std::vector<std::size_t> items_;  // of the points, the shard's; each is as dear as the others
  std::mutex mutex_;
  std::vector<std::string> lines_;  // of each of them; empty: none
  Progress progress_;
  std::size_t done_ = 0, found_ = 0;
  int status_ = exit_done;
};

struct AllPoints {
  std::vector<SweptPoint> points;
  std::vector<Json> lines;
  std::string text;
};

Result<AllPoints> read_lines(const std::vector<std::string>& lines) {
  AllPoints all;
  for (const auto& line : lines) {
    if (line.empty()) continue;
    auto point = read_swept_point(line, "points.jsonl", all.points.size() + 1);
    if (!point) return point.error();
    all.points.push_back(*std::move(point));
    all.lines.push_back(Json::parse(line));
    all.text += line;
  }
  return all;
}

Outcome write_files(const AllPoints& all, const SweepOptions& options) {
  const auto figures = names_of_figures(all.points);
  const auto& figure = options.figure.empty() ? figures.front() : options.figure;
  std::vector<std::string> pictures;
  for (const auto& [name, svg] :
       {std::pair{"heat.svg", heat_maps(all.points, figure)}, std::pair{"curves.svg", curves(all.points, figure)}}) {
    std::error_code unknown;
    fs::remove(in_folder(options, name), unknown);
    if (svg.empty()) continue;
    pictures.emplace_back(name);
    if (auto problem = replace_file(in_folder(options, name), svg)) return problem;
  }
  for (const auto& [name, text] :
       {std::pair{"points.jsonl", all.text}, std::pair{"points.csv", sweep_csv(all.points)},
        std::pair{"index.html", sweep_page(all.lines, fs::path(options.output).lexically_normal().string(), pictures)}})
    if (auto problem = replace_file(in_folder(options, name), text)) return problem;
  return std::nullopt;
}

// The table; of all points together the files of the folder as well.
int tell(const std::vector<std::string>& lines, const SweepOptions& options, bool whole, int status) {
  const auto all = read_lines(lines);
  if (!all) return report(all.error()), exit_impossible;
  if (all->points.empty()) return status;
  if (whole)
    if (const auto problem = write_files(*all, options)) return report(*problem), exit_impossible;
  put(stdout, sweep_text(all->points));
  return status;
}

Result<std::vector<SweepPoint>> points_of(const SweepOptions& options) {
  const auto text = read_file(options.grid);
  if (!text) return text.error();
  auto points = read_sweep_grid(*text, options.grid);
  if (!points) return points;
  for (const auto& point : *points)
    if (!point.policy.empty() && !parse_choice(point.policy))
      return Error{options.grid,
                   fmt::format("there is no policy {}; expected {}", in_quotes(point.policy), choice_names())};
  return points;
}

}  // namespace

int run_sweep(const SweepOptions& options) {
  std::error_code problem;
  fs::create_directories(fs::path(options.output) / "points", problem);
  if (problem) return report({options.output, "is no folder and cannot become one"}), exit_impossible;
  if (!options.shards.merge.empty()) {
    const auto merged = merge_shards("sweep", options.shards.merge);
    if (!merged) return report(merged.error()), exit_impossible;
    return tell(merged->told, options, true, merged->status);
  }
  auto points = points_of(options);
  if (!points) return report(points.error()), exit_impossible;
  auto given = sweep_given(options.traces, options.replay);
  if (!given) return report(given.error()), exit_impossible;
  Sweeping sweeping(options, *std::move(given), *std::move(points));
  sweeping.run();
  auto made = sweeping.report();
  made.status = tell(made.told, options, made.shard.count == 1, made.status);
  return keep_report(options.shards, made);
}

void describe_sweep(CLI::App& command, SweepOptions& options) {
  options.replay.physics = false;
  command.add_option("GRID", options.grid, "the points: a JSON file (replay/sweep/SWEEP.md)");
  command.add_option("TRACE", options.traces, "traces (.jsonl, .jsonl.gz)");
  command.add_option("-o,--output", options.output, "a folder; points that are in it are not done again")->required();
  std::vector<std::string> names;
  for (const auto& figure : sweep_figures()) names.emplace_back(figure.name);
  command.add_option("--figure", options.figure, "in pictures; otherwise the first that the points have")
      ->check(CLI::IsMember(names));
  auto variant = std::make_shared<std::string>();
  auto* varied = command
                     .add_option("--variant", *variant,
                                 "how far what was observed leads the runs, as for score: free, world, teacher")
                     ->check(CLI::IsMember({"free", "world", "teacher"}));
  command
      .add_flag_callback(
          "--physics", [&options] { options.replay.physics = true; }, "replay in MuJoCo's world")
      ->excludes(varied);
  add_setting_options(command, options.replay);
  command.add_option("-j,--jobs", options.jobs, "how many points at a time")->check(CLI::Range(1, 256));
  add_shard_options(command, options.shards, "TRACE", "replaying");
  command.footer(
      "A point is a setting of the machine, a policy and a seed; all traces are replayed at each, in the kinematic\n"
      "world. The folder gets points.jsonl, points.csv, heat.svg, curves.svg and index.html.\n"
      "Exit status: 0 done, 2 a trace cannot be replayed at a point (the others are done), or a shard is missing.\n"
      "Examples: continua sweep grid.json traces/pilot/*.jsonl -o sweep -j 2\n"
      "          continua sweep grid.json traces/pilot/*.jsonl -o sweep --shard 1/2 --report 1.json\n"
      "          continua sweep --merge 1.json 2.json -o sweep");
  command.callback([&options, variant] {
    expect_items(options.traces, options.shards, "GRID and TRACE");
    options.replay.variant = parse_variant(*variant).value_or(Variant::free);
  });
}

}  // namespace continua
