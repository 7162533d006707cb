#include "replay/commands/check.h"

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <streambuf>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "replay/commands/validate.h"
#include "replay/data_paths.h"
#include "replay/examples.h"
#include "replay/language_loading.h"
#include "replay/session.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

// Swallows what is written to it.
struct Nowhere : std::streambuf {
  int overflow(int c) override { return traits_type::not_eof(c); }
  std::streamsize xsputn(const char*, std::streamsize count) override { return count; }
};

bool is_lexicon(const fs::path& path) { return is_folder(path) && path.parent_path().filename() == "lexicon"; }
bool is_machine(const fs::path& path) {
  return path.extension() == ".jff" || (path.extension() == ".json" && path.parent_path().filename() == "machines");
}
bool is_phrases(const fs::path& path) {
  return path.extension() == ".json" && path.parent_path().filename() == "phrases";
}
bool is_trace(const fs::path& path) { return path.string().ends_with(".trace.jsonl"); }

// What of a folder can be checked, in the order of the names.
void collect(const fs::path& path, std::vector<fs::path>& items) {
  if (!is_folder(path) || is_lexicon(path)) return items.push_back(path);
  std::vector<fs::path> entries;
  std::error_code problem;
  for (const auto& entry : fs::directory_iterator(path, problem)) entries.push_back(entry.path());
  std::sort(entries.begin(), entries.end());
  for (const auto& entry : entries)
    if (is_folder(entry) || is_machine(entry) || is_phrases(entry) || is_trace(entry)) collect(entry, items);
}

class Checking {
 public:
  Checking(const CheckOptions& options, DataPaths data) : options_(options), data_(std::move(data)) {}

  int run() {
    auto paths = options_.paths;
    if (paths.empty()) paths = {data_.knowledge.string()};
    std::vector<fs::path> items;
    for (const auto& path : paths) collect(fs::path(path).lexically_normal(), items);
    for (const auto& item : items) {
      if (is_lexicon(item))
        lexicon(item);
      else if (is_phrases(item))
        phrases(item);
      else if (item.extension() == ".jsonl")
        trace(item);
      else
        machine(item);
    }
    return status_;
  }

 private:
  void trouble(const Error& error) {
    report(error);
    status_ = exit_impossible;
  }

  void verdict(const fs::path& item, std::size_t count, const char* what, const std::vector<std::string>& problems) {
    for (const auto& problem : problems) fmt::print(stderr, "{}\n", problem);
    fmt::print("{} {}: {}\n", problems.empty() ? "ok  " : "FAIL", item.string(),
               problems.empty() ? counted(count, what)
                                : fmt::format("{} of {} not true", problems.size(), counted(count, what)));
    if (!problems.empty()) status_ = std::max<int>(status_, exit_no);
  }

  void lexicon(const fs::path& path) {
    const auto lexicon = load_named_lexicon(data_, path.string(), "");
    if (!lexicon) return trouble(lexicon.error());
    std::vector<std::string> problems;
    for (const auto& problem : check_examples(**lexicon)) problems.push_back(problem.text());
    verdict(path, (*lexicon)->examples.size(), "example", problems);
  }

  void phrases(const fs::path& path) {
    const auto text = read_file(path.string());
    if (!text) return trouble(text.error());
    const auto check = check_file(*text, path.string());
    for (const auto& problem : check.problems) trouble(problem);
    if (check.problems.empty()) fmt::print("ok   {}: {}\n", path.string(), check.summary);
  }

  void machine(const fs::path& path) {
    auto loaded = load_machine(path.string(), data_);
    if (!loaded) return trouble(loaded.error());
    const auto machine = std::make_shared<const Machine>(*std::move(loaded));
    auto language = load_language(data_, *machine);
    if (!language) return trouble(language.error());
    auto problems = broken_examples(machine, std::make_shared<const Language>(*std::move(language)));
    for (auto& problem : problems) problem = path.string() + ": " + problem;
    verdict(path, machine->examples.size(), "example", problems);
  }

  void trace(const fs::path& path) {
    ReplayOptions options;
    options.knowledge = options_.knowledge;
    options.learned = options_.learned;
    options.physics = options_.physics;
    auto session = Session::load(path.string(), options);
    if (!session) return trouble(session.error());
    Nowhere nowhere;
    std::ostream log(&nowhere);
    const auto summary = session->run(log);
    if (const auto problem = session->keep_learned()) return trouble(*problem);
    const auto unmet = static_cast<std::size_t>(summary.expectations - summary.expectations_met);
    std::vector<std::string> problems(unmet, path.string() + ": an expectation is not met (see continua replay)");
    if (problems.size() > 1) problems.resize(1);
    verdict(path, static_cast<std::size_t>(summary.expectations), "expectation", problems);
  }

  const CheckOptions& options_;
  DataPaths data_;
  int status_ = exit_done;
};

}  // namespace

int run_check(const CheckOptions& options) {
  auto data = find_data_paths(options.knowledge);
  if (!data) return report(data.error()), exit_impossible;
  return Checking(options, *std::move(data)).run();
}

void add_check_command(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand(
      "check", "Run the examples of machines and lexicons, check phrases and traces' expectations");
  auto options = std::make_shared<CheckOptions>();
  command->add_option("PATH", options->paths,
                      "machines, folders of lexicon/, traces, or folders of them; the knowledge folder if left out");
  command->add_option("--knowledge", options->knowledge, "folder to use instead of engine/knowledge");
  command->add_option("--learned", options->learned,
                      "a file of what was taught: traces read it if it exists, and write what they change");
  command->add_flag("!--no-physics", options->physics,
                    "replay traces in the kinematic world, where every act succeeds");
  command->footer(
      "Exit status: 0 all is true, 1 something is not, 2 a file cannot be used.\nExample: continua check traces");
  command->callback([options, &run] { run = [options] { return run_check(*options); }; });
}

}  // namespace continua
