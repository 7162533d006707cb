#include "continua/replay/commands/coverage.h"

#include <algorithm>
#include <filesystem>
#include <mutex>
#include <optional>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/core/gzip_name.h"
#include "continua/core/located_json.h"
#include "continua/core/several_at_once.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/knowledge_files/language_loading.h"
#include "continua/language/reduction.h"
#include "continua/language/vocabulary.h"
#include "continua/replay/coverage/coverage_part.h"
#include "continua/replay/coverage/coverage_text.h"
#include "continua/replay/log/log_file.h"
#include "continua/replay/session/session.h"
#include "continua/replay/session/shelf.h"
#include "continua/replay/terminal/progress.h"
#include "continua/replay/trace/trace_name.h"
#include "continua/term/raising_file.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view run_ending = ".run.jsonl";

bool is_run_name(std::string_view path) { return without_gzip_ending(path).ends_with(run_ending); }

// NAME.run.jsonl or NAME.WORLD.run.jsonl next to NAME.trace.jsonl, each of them packed or not.
bool goes_with_a_trace(const fs::path& log) {
  std::string stem(without_gzip_ending(log.string()));
  stem.resize(stem.size() - run_ending.size());
  std::error_code problem;
  for (const auto& name : {stem, fs::path(stem).replace_extension().string()})
    for (const auto packed : {std::string_view(), gzip_ending})
      if (fs::exists(fmt::format("{}{}{}", name, trace_ending, packed), problem)) return true;
  return false;
}

// The files that a folder stands for, in the order of the names.
std::vector<std::string> files_of(const fs::path& path) {
  if (!is_folder(path)) return {path.string()};
  std::vector<std::string> files;
  std::error_code problem;
  for (auto entry = fs::recursive_directory_iterator(path, problem); entry != fs::end(entry); entry.increment(problem))
    if (const auto name = entry->path().string();
        is_trace_name(name) || (is_run_name(name) && !goes_with_a_trace(entry->path())))
      files.push_back(name);
  std::sort(files.begin(), files.end());
  return files;
}

bool is_run_log(const std::string& path) {
  const auto line = first_line(path);
  if (!line) return false;
  const auto header = parse_json_line(without_byte_order_mark(*line), path, 1);
  return header && header->is_object() && header->contains("kind") && (*header)["kind"] == "run";
}

// Counts files, several at once.
class Counting {
 public:
  Counting(const CoverageOptions& options, std::vector<std::string> files)
      : options_(options),
        files_(std::move(files)),
        items_(dealt(options.shards.shard, costs_of(files_))),
        found_(items_.size()),
        progress_(items_.size()) {}

  void run() {
    several_at_once(items_.size(), options_.jobs, [this](std::size_t i) {
      const auto& file = files_[items_[i]];
      auto coverage = is_run_log(file) ? of_log(RunIndex::open(file)) : of_trace(file);
      const std::lock_guard lock(mutex_);
      found_[i] = std::move(coverage);
      progress_.show(i, 1);
    });
    progress_.clear();
  }

  /// The shard's files; reports those that cannot be used.
  ShardReport report() const {
    ShardReport all{"coverage", options_.shards.shard, files_.size(), items_, exit_done, {}};
    for (const auto& one : found_) {
      all.told.push_back(text_of_part(one->ok() ? std::optional(**one) : std::nullopt));
      if (one->ok()) continue;
      continua::report(one->error());
      all.status = exit_impossible;
    }
    return all;
  }

 private:
  Result<MachineCoverage> of_log(const Result<RunIndex>& run) {
    if (!run) return run.error();
    if (!run->trouble().empty()) warn({run->path(), run->trouble()});
    return coverage_of(*run);
  }

  Result<MachineCoverage> of_trace(const std::string& path) {
    ReplayOptions options;
    options.knowledge = options_.knowledge;
    options.shelf = shelf_;
    options.physics = false;
    auto session = Session::load(path, options);
    if (!session) return session.error();
    if (session->warning()) warn(*session->warning());
    std::ostringstream log;
    session->run(log);
    return of_log(RunIndex::of_text(std::move(log).str(), path));
  }

  void warn(const Error& warning) {
    const std::lock_guard lock(mutex_);
    if (!warned_.insert(warning.text()).second) return;
    progress_.clear();
    report_warning(warning);
  }

  const CoverageOptions& options_;
  const std::shared_ptr<Shelf> shelf_ = std::make_shared<Shelf>();
  std::vector<std::string> files_;
  const std::vector<std::size_t> items_;  // of the files, the shard's
  std::mutex mutex_;
  std::vector<std::optional<Result<MachineCoverage>>> found_;
  Progress progress_;
  std::set<std::string> warned_;
};

// The senses of all words: the lexicon's own, and those that its attributes' values make.
std::vector<CoverageItem> entries_of(const std::shared_ptr<const Lexicon>& lexicon) {
  const Vocabulary vocabulary(lexicon, WorldSnapshot());
  std::vector<CoverageItem> entries;
  for (const auto& word : vocabulary.words()) {
    const auto known = vocabulary.entries(word);
    for (const auto* sense : Vocabulary::senses(known))
      entries.push_back(lexicon_entry(word, sense->category.text(), print(with_nice_variables(sense->term))));
    if (std::any_of(known.begin(), known.end(), [](const auto* entry) { return entry->skip.has_value(); }))
      entries.push_back(lexicon_entry(word, "", ""));
  }
  return entries;
}

std::vector<CoverageItem> named(const auto& rules) {
  std::vector<CoverageItem> items;
  for (const auto& rule : rules) items.push_back({rule.name, "", "", 0});
  return items;
}

// Adds the reachable parts of the knowledge. A log does not hold it: the lexicon must be the one that the log names.
void add_knowledge(MachineCoverage& machine, const DataPaths& data) {
  const auto raising_path = (data.knowledge / "raising.json").lexically_normal().string();
  auto& raising = machine.kind(raising_rules);
  if (!machine.lexicon.empty() || !raising.items.empty())
    if (const auto rules = load_raising(raising_path, names_of_terms())) add_reachable(raising, named(*rules));
  if (machine.lexicon.empty()) return;
  const auto lexicon = load_named_lexicon(data, machine.lexicon, machine.name);
  if (!lexicon || (*lexicon)->digest != machine.lexicon_digest)
    return report_warning({machine.name, fmt::format("the lexicon {} is not the one of the runs any more; of it only "
                                                     "what they used is told",
                                                     in_quotes(machine.lexicon))});
  add_reachable(machine.kind(lexicon_rules), named((*lexicon)->rules));
  add_reachable(machine.kind(lexicon_entries), entries_of(*lexicon));
}

// The report that the parts give. `whole`: they are all that there are.
int tell(const std::vector<std::string>& parts, const CoverageOptions& options, bool whole, int status) {
  const auto data = find_data_paths(options.knowledge);
  if (!data) return report(data.error()), exit_impossible;
  std::vector<MachineCoverage> runs;
  for (const auto& part : parts)
    if (const auto problem = add_part(runs, part)) return report(*problem), exit_impossible;
  auto machines = by_machine(runs);
  for (auto& machine : machines) add_knowledge(machine, *data);
  const auto text = options.json ? coverage_json(machines).dump(2, ' ', false, Json::error_handler_t::replace) + "\n"
                                 : coverage_text(machines, options.never);
  if (const auto problem = write_file("-", text)) return report(*problem), exit_impossible;
  if (status == exit_impossible || !whole) return status;
  for (const auto& machine : machines) {
    const auto reached = percent(machine.reached(), machine.reachable());
    if (reached >= static_cast<std::size_t>(options.at_least)) continue;
    report({machine.name, fmt::format("{} % reached; expected at least {} %", reached, options.at_least)});
    status = exit_no;
  }
  return status;
}

}  // namespace

int run_coverage(const CoverageOptions& options) {
  if (!options.shards.merge.empty()) {
    const auto merged = merge_shards("coverage", options.shards.merge);
    if (!merged) return report(merged.error()), exit_impossible;
    return tell(merged->told, options, true, merged->status);
  }
  bool usable = true;
  std::vector<std::string> files;
  for (const auto& path : options.paths) {
    const auto found = files_of(fs::path(path).lexically_normal());
    if (found.empty()) {
      report({path, "found neither a trace (.trace.jsonl) nor a run log (.run.jsonl), packed or not, in it"});
      usable = false;
    }
    files.insert(files.end(), found.begin(), found.end());
  }
  Counting counting(options, std::move(files));
  counting.run();
  auto made = counting.report();
  if (!usable) made.status = exit_impossible;
  made.status = tell(made.told, options, made.shard.count == 1, made.status);
  return keep_report(options.shards, made);
}

void describe_coverage(CLI::App& command, CoverageOptions& options) {
  command.add_option("PATH", options.paths,
                     "run logs, traces, or folders of them; traces are replayed in the kinematic world, instead of\n"
                     "the logs beside them in a folder");
  command.add_flag("--json", options.json, "all that can be reached, with counts, as JSON");
  command.add_flag("--never", options.never, "tell all that was never reached, not the first few of each kind");
  command
      .add_option("--at-least", options.at_least,
                  "PERCENT: end with 1 where less of what is a machine's own is reached")
      ->check(CLI::Range(0, 100));
  command.add_option("--knowledge", options.knowledge, "folder to use instead of engine/knowledge");
  command.add_option("-j,--jobs", options.jobs, "how many files at a time")->check(CLI::Range(1, 256));
  add_shard_options(command, options.shards, "PATH", "counting");
  command.footer(
      "Of a condition both outcomes count: that it held (its transition could have fired) and that it did not.\n"
      "Exit status: 0 done, 1 less than --at-least, 2 a file cannot be used.\n"
      "Examples: continua coverage traces -j 4\n"
      "          continua coverage runs/*.run.jsonl --never\n"
      "          continua coverage traces --shard 1/2 --report 1.json\n"
      "          continua coverage --merge 1.json 2.json");
  command.callback([&options] { expect_items(options.paths, options.shards, "PATH"); });
}

}  // namespace continua
