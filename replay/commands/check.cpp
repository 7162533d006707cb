#include "replay/commands/check.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <filesystem>
#include <iostream>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "machine_file/machine_loader.h"
#include "replay/check.h"
#include "replay/commands/junit.h"
#include "replay/commands/progress.h"
#include "replay/commands/validate.h"
#include "replay/data_paths.h"
#include "replay/examples.h"
#include "replay/language_loading.h"
#include "voxml/program_check.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

bool is_lexicon(const fs::path& path) { return is_folder(path) && path.parent_path().filename() == "lexicon"; }
bool is_machine(const fs::path& path) {
  return path.extension() == ".jff" || (path.extension() == ".json" && path.parent_path().filename() == "machines");
}
// Files that hold no examples: what can be wrong with them is what validate tells.
bool is_data(const fs::path& path) {
  const auto folder = path.parent_path().filename();
  return path.extension() == ".json" && (folder == "phrases" || folder == "gestures");
}
bool is_voxemes(const fs::path& path) { return is_folder(path) && path.filename() == "voxemes"; }
bool is_trace(const fs::path& path) { return path.string().ends_with(".trace.jsonl"); }
// Goes with its trace.
bool is_approved_run(const fs::path& path) {
  return path.string().ends_with(".run.jsonl") || path.string().ends_with(".run.json");
}

// What of a folder can be checked, in the order of the names.
void collect(const fs::path& path, std::vector<fs::path>& items) {
  if (is_approved_run(path)) return;
  if (!is_folder(path) || is_lexicon(path) || is_voxemes(path)) return items.push_back(path);
  std::vector<fs::path> entries;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(path, problem)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  for (const auto& entry : entries)
    if (is_folder(entry) || is_machine(entry) || is_data(entry) || is_trace(entry)) collect(entry, items);
}

// What came out for one file.
struct Finding {
  std::string verdict;  ///< "12 examples", "changed: …"
  int status = exit_done;
  std::vector<std::string> problems;  ///< each on a line of its own
  std::optional<TraceCheck> trace;
};

// Checks files, several at once; their lines come out in order.
class Checking {
 public:
  Checking(const CheckOptions& options, const DataPaths& data, std::vector<fs::path> items)
      : options_(options), data_(data), items_(std::move(items)), findings_(items_.size()), progress_(items_.size()) {}

  void run() {
    std::vector<std::thread> threads;
    const auto count =
        std::min(static_cast<std::size_t>(jobs_at_a_time(options_.jobs, options_.learned)), items_.size());
    for (std::size_t i = 1; i < count; ++i) threads.emplace_back([this] { work(); });
    work();
    for (auto& thread : threads) thread.join();
  }

  int status() const {
    int status = exit_done;
    for (const auto& finding : findings_) status = std::max(status, finding->status);
    return status;
  }

  std::vector<JunitCase> cases() const {
    std::vector<JunitCase> cases;
    for (std::size_t i = 0; i < items_.size(); ++i) {
      const auto& finding = *findings_[i];
      std::string failure = finding.status == exit_done ? "" : finding.verdict;
      for (const auto& problem : finding.problems) failure += "; " + problem;
      cases.push_back({items_[i].parent_path().string(), items_[i].filename().string(), failure});
    }
    return cases;
  }

  /// Writes the runs that are new or not as they were approved. Afterwards they hold.
  int approve() {
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < items_.size(); ++i)
      if (findings_[i]->trace && can_be_approved(findings_[i]->trace->verdict)) open.push_back(i);
    if (open.empty()) return status();
    if (!options_.yes) {
      if (!isatty(STDIN_FILENO)) {
        report({"--approve", fmt::format("{} would be approved, and nobody can be asked; expected --yes",
                                         counted(open.size(), "run"))});
        return exit_impossible;
      }
      fmt::print("Approve {}? [y/N] ", counted(open.size(), "run"));
      std::fflush(stdout);
      std::string answer;
      if (!std::getline(std::cin, answer) || (answer != "y" && answer != "yes")) return status();
    }
    for (const auto i : open) {
      const auto& check = *findings_[i]->trace;
      const auto approval = approval_of(items_[i].string(), check.run, check.approved);
      if (const auto problem = write_file(approval.path, approval.content)) return report(*problem), exit_impossible;
      std::error_code none;
      if (check.approved && takes_place_of(approval, *check.approved)) fs::remove(check.approved->path, none);
      fmt::print("approved {}\n", approval.path);
      findings_[i]->status = exit_done;
    }
    return status();
  }

 private:
  void work() {
    for (std::size_t i = next_++; i < items_.size(); i = next_++) finish(i, check(i));
  }

  Finding check(std::size_t index) {
    const auto& item = items_[index];
    if (is_lexicon(item)) return lexicon(item);
    if (is_voxemes(item)) return voxemes(item);
    if (is_data(item)) return data(item);
    return item.extension() == ".jsonl" ? trace(index) : machine(item);
  }

  void finish(std::size_t index, Finding finding) {
    const std::lock_guard lock(mutex_);
    findings_[index] = std::move(finding);
    progress_.show(index, 1);
    progress_.clear();
    const auto& traced = findings_[index]->trace;
    if (traced && traced->warning && warned_.insert(traced->warning->text()).second) report_warning(*traced->warning);
    for (; printed_ < items_.size() && findings_[printed_]; ++printed_) {
      const auto& one = *findings_[printed_];
      for (const auto& problem : one.problems) fmt::print(stderr, "{}\n", problem);
      fmt::print("{} {}: {}\n", one.status == exit_done ? "ok  " : "FAIL", items_[printed_].string(), one.verdict);
    }
    std::fflush(stdout);
  }

  static Finding cannot_be_used(const Error& error) { return {"cannot be used", exit_impossible, {error.text()}, {}}; }

  static Finding examples(std::size_t count, std::vector<std::string> problems) {
    const auto all = counted(count, "example");
    if (problems.empty()) return {all, exit_done, {}, {}};
    return {fmt::format("{} of {} not true", problems.size(), all), exit_no, std::move(problems), {}};
  }

  Finding lexicon(const fs::path& path) {
    const auto lexicon = load_named_lexicon(data_, path.string(), "");
    if (!lexicon) return cannot_be_used(lexicon.error());
    std::vector<std::string> problems;
    for (const auto& problem : check_examples(**lexicon)) problems.push_back(problem.text());
    return examples((*lexicon)->examples.size(), std::move(problems));
  }

  Finding voxemes(const fs::path& folder) {
    const auto read = read_catalogue(folder.string());
    std::vector<std::string> problems;
    for (const auto& problem : read.problems) problems.push_back(problem.text());
    for (const auto& problem : check_programs(read.catalogue)) problems.push_back(problem.text());
    const auto all = counted(read.documents, "voxeme");
    if (!read.problems.empty())
      return {fmt::format("{} cannot be used", counted(read.problems.size(), "document")),
              exit_impossible,
              std::move(problems),
              {}};
    if (problems.empty()) return {all, exit_done, {}, {}};
    return {fmt::format("{} in {}", counted(problems.size(), "problem"), all), exit_no, std::move(problems), {}};
  }

  Finding data(const fs::path& path) {
    const auto text = read_file(path.string());
    if (!text) return cannot_be_used(text.error());
    const auto check = check_file(*text, path.string());
    if (check.problems.empty()) return {check.summary, exit_done, {}, {}};
    std::vector<std::string> problems;
    for (const auto& problem : check.problems) problems.push_back(problem.text());
    return {counted(problems.size(), "problem"), exit_no, std::move(problems), {}};
  }

  Finding machine(const fs::path& path) {
    auto loaded = load_machine(path.string(), data_);
    if (!loaded) return cannot_be_used(loaded.error());
    const auto machine = std::make_shared<const Machine>(*std::move(loaded));
    auto language = load_language(data_, *machine);
    if (!language) return cannot_be_used(language.error());
    auto problems = broken_examples(machine, std::make_shared<const Language>(*std::move(language)));
    for (auto& problem : problems) problem = path.string() + ": " + problem;
    return examples(machine->examples.size(), std::move(problems));
  }

  Finding trace(std::size_t index) {
    ReplayOptions options;
    options.knowledge = options_.knowledge;
    options.learned = options_.learned;
    options.physics = options_.physics.value_or(!options_.approve);
    options.progress = [this, index](double done) {
      const std::lock_guard lock(mutex_);
      progress_.show(index, done);
    };
    Finding finding;
    finding.trace = check_trace(items_[index].string(), options);
    const auto& check = *finding.trace;
    finding.status = is_failure(check.verdict) ? exit_no : exit_done;
    finding.verdict =
        check.reason.empty() ? text(check.verdict) : fmt::format("{}: {}", text(check.verdict), check.reason);
    if (finding.status == exit_done)
      finding.verdict = counted(static_cast<std::size_t>(check.expectations), "expectation") + ", " + finding.verdict;
    return finding;
  }

  const CheckOptions& options_;
  const DataPaths& data_;
  std::vector<fs::path> items_;
  std::mutex mutex_;
  std::vector<std::optional<Finding>> findings_;
  Progress progress_;
  std::set<std::string> warned_;
  std::size_t printed_ = 0;
  std::atomic<std::size_t> next_ = 0;
};

}  // namespace

std::optional<Shard> parse_shard(const std::string& text) {
  Shard shard;
  const auto* end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  if (index.ec != std::errc() || index.ptr == end || *index.ptr != '/') return std::nullopt;
  const auto count = std::from_chars(index.ptr + 1, end, shard.count);
  if (count.ec != std::errc() || count.ptr != end || shard.index < 1 || shard.index > shard.count) return std::nullopt;
  return shard;
}

int run_check(const CheckOptions& options) {
  const auto data = find_data_paths(options.knowledge);
  if (!data) return report(data.error()), exit_impossible;
  auto paths = options.paths;
  if (paths.empty()) paths = {data->knowledge.string()};
  std::vector<fs::path> all, items;
  for (const auto& path : paths) {
    std::error_code problem;
    if (!fs::exists(path, problem)) return report({path, "there is no such file or folder"}), exit_impossible;
    collect(fs::path(path).lexically_normal(), all);
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    if (i % options.shard.count == options.shard.index - 1) items.push_back(all[i]);

  Checking checking(options, *data, std::move(items));
  checking.run();
  const int status = options.approve ? checking.approve() : checking.status();
  if (!options.junit.empty())
    if (const auto problem = write_file(options.junit, junit_xml("continua check", checking.cases())))
      return report(*problem), exit_impossible;
  return status;
}

void add_check_command(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand(
      "check", "Check what the project's files say of themselves, and hold traces against their approved runs");
  auto options = std::make_shared<CheckOptions>();
  command->add_option("PATH", options->paths,
                      "machines, folders of lexicon/, phrases, gestures, folders voxemes, traces, or folders of them;\n"
                      "the knowledge folder if left out");
  command->add_option("--knowledge", options->knowledge, "folder to use instead of engine/knowledge");
  command->add_option("--learned", options->learned,
                      "a file of what was taught: traces read it if it exists, and write what they change");
  auto* physics = command->add_flag_callback(
      "--physics", [options] { options->physics = true; },
      "replay traces in MuJoCo's world, also with --approve, which else takes the kinematic one");
  command
      ->add_flag_callback(
          "--no-physics", [options] { options->physics = false; },
          "replay traces in the kinematic world, where every act succeeds")
      ->excludes(physics);
  command->add_flag("--approve", options->approve,
                    "ask, then write the runs that are new or not as approved beside their traces");
  command->add_flag("--yes", options->yes, "with --approve: do not ask")->needs("--approve");
  command->add_option("-j,--jobs", options->jobs, "how many files at a time")->check(CLI::Range(1, 256));
  auto shard = std::make_shared<std::string>();
  command->add_option("--shard", *shard, "I/N: only part I of N, from 1")->check([](const std::string& text) {
    return parse_shard(text) ? std::string() : fmt::format("found {}; expected I/N, I from 1 to N", in_quotes(text));
  });
  command->add_option("--junit", options->junit, "write what came out to this file, as JUnit's XML");
  command->footer(
      "Of a trace: same (every byte), same decisions (as in another world), new (nothing is approved), changed,\n"
      "stale (approved from another trace), broken (cannot be replayed, or an expectation is not met).\n"
      "Exit status: 0 all is true, 1 something is not, 2 a file cannot be used.\n"
      "Examples: continua check traces -j 4\n"
      "          continua check traces --approve");
  command->callback([options, shard, &run] {
    if (!shard->empty()) options->shard = *parse_shard(*shard);
    run = [options] { return run_check(*options); };
  });
}

}  // namespace continua
