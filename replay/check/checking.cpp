#include "continua/replay/check/checking.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/core/several_at_once.h"
#include "continua/facts/formations.h"
#include "continua/facts/world_facts.h"
#include "continua/knowledge_files/language_loading.h"
#include "continua/machine_file/machine_loader.h"
#include "continua/replay/check/annotations.h"
#include "continua/replay/check/check_failures.h"
#include "continua/replay/check/examples.h"
#include "continua/replay/check/file_kinds.h"
#include "continua/replay/terminal/shell_word.h"
#include "continua/voxml/program_check.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

CheckCase holds(std::string sentence) { return {"", false, "true", std::move(sentence), exit_done, 0, {}, "", ""}; }

CheckCase does_not_hold(std::string sentence, std::vector<Error> problems) {
  return {"", false, "not true", std::move(sentence), exit_no, 0, std::move(problems), "", ""};
}

CheckCase cannot_be_used(std::string sentence, std::vector<Error> problems) {
  return {"", false, "cannot be used", std::move(sentence), exit_impossible, 0, std::move(problems), "", ""};
}
CheckCase cannot_be_used(const Error& error) { return cannot_be_used("cannot be used", {error}); }

CheckCase examples(std::size_t count, std::vector<Error> problems) {
  const auto all = counted(count, "example");
  if (problems.empty()) return holds(all);
  auto sentence = fmt::format("{} of {} not true", problems.size(), all);
  return does_not_hold(std::move(sentence), std::move(problems));
}

CheckCase check_lexicon_at(const fs::path& path, const DataPaths& data) {
  const auto lexicon = load_named_lexicon(data, path.string(), "");
  if (!lexicon) return cannot_be_used(lexicon.error());
  const auto all = load_examples(**lexicon);
  if (!all) return cannot_be_used(all.error());
  return examples(all->size(), check_examples(*all, **lexicon));
}

CheckCase check_voxemes_at(const fs::path& folder, const DataPaths&) {
  const auto read = read_catalogue(folder.string());
  auto problems = read.problems;
  for (auto& problem : check_programs(read.catalogue)) problems.push_back(std::move(problem));
  const Formations formations(read.catalogue, WorldFacts::signature());
  problems.insert(problems.end(), formations.problems().begin(), formations.problems().end());
  if (!read.problems.empty())
    return cannot_be_used(fmt::format("{} cannot be used", counted(read.problems.size(), "document")),
                          std::move(problems));
  const auto all = counted(read.documents, "voxeme");
  if (problems.empty()) return holds(all);
  const auto sentence = fmt::format("{} in {}", counted(problems.size(), "problem"), all);
  return does_not_hold(sentence, std::move(problems));
}

CheckCase check_data_at(const fs::path& path, const DataPaths&) {
  const auto text = read_file(path.string());
  if (!text) return cannot_be_used(text.error());
  auto check = check_file(*text, path.string());
  if (check.problems.empty()) return holds(check.summary);
  const auto sentence = counted(check.problems.size(), "problem");
  return does_not_hold(sentence, std::move(check.problems));
}

CheckCase check_machine_at(const fs::path& path, const DataPaths& data) {
  auto loaded = load_machine(path.string(), data);
  if (!loaded) return cannot_be_used(loaded.error());
  const auto machine = std::make_shared<const Machine>(*std::move(loaded));
  auto language = load_language(data, *machine);
  if (!language) return cannot_be_used(language.error());
  std::vector<Error> problems;
  for (auto& problem : broken_examples(machine, std::make_shared<const Language>(*std::move(language))))
    problems.push_back({path.string(), std::move(problem)});
  return examples(machine->examples.size(), std::move(problems));
}

}  // namespace

Checking::Checking(const CheckOptions& options, const DataPaths& data, std::vector<CheckItem> items)
    : options_(options), data_(data), items_(std::move(items)), findings_(items_.size()), progress_(items_.size()) {}

void Checking::run() {
  several_at_once(items_.size(), jobs_at_a_time(options_.jobs, options_.learned),
                  [this](std::size_t i) { finish(i, check(i)); });
}

std::vector<CheckCase> Checking::cases() const {
  std::vector<CheckCase> cases;
  for (const auto& finding : findings_) cases.push_back(finding->told);
  return cases;
}

const TraceCheck* Checking::trace(std::size_t index) const {
  const auto& trace = findings_[index]->trace;
  return trace ? &*trace : nullptr;
}

Checking::Finding Checking::check(std::size_t index) {
  const auto& [path, kind, name] = items_[index];
  if (kind == ItemKind::trace) return trace_finding(index);
  Finding finding;
  finding.told = kind == ItemKind::lexicon   ? check_lexicon_at(path, data_)
                 : kind == ItemKind::voxemes ? check_voxemes_at(path, data_)
                 : kind == ItemKind::data    ? check_data_at(path, data_)
                                             : check_machine_at(path, data_);
  return finding;
}

Checking::Finding Checking::trace_finding(std::size_t index) {
  ReplayOptions options;
  options.knowledge = options_.knowledge;
  options.shelf = shelf_;
  options.learned = options_.learned;
  options.language = options_.language;
  options.settings = options_.settings;
  options.physics = options_.physics.value_or(!options_.approve);
  options.progress = [this, index](double done) {
    const std::lock_guard lock(mutex_);
    progress_.show(index, done);
  };
  Finding finding;
  auto check = check_trace(items_[index].path.string(), options);
  const bool fails = is_failure(check.verdict) || (options_.strict && check.verdict == Verdict::same_decisions);
  auto& told = finding.told;
  told.is_trace = true;
  told.verdict = name_of(check.verdict);
  told.status = fails ? exit_no : exit_done;
  told.sentence = check.reason.empty() ? told.verdict : fmt::format("{}: {}", told.verdict, check.reason);
  if (!fails)
    told.sentence = counted(static_cast<std::size_t>(check.expectations), "expectation") + ", " + told.sentence;
  if (fails) compare(check);
  told.line = check.line;
  if (fails) told.details = details_of(check);
  if (fails && !check.run.empty() && !options_.failures.empty() && !options_.approve) {
    auto page = keep_failure(index, check);
    if (page) {
      told.page = *page;
    } else {
      told.problems.push_back(page.error());
      told.status = exit_impossible;
    }
  }
  if (!options_.approve || !(fails || can_be_approved(check.verdict))) {
    check.run.clear();
    check.compared.reset();
  }
  finding.trace = std::move(check);
  return finding;
}

Result<std::string> Checking::keep_failure(std::size_t index, const TraceCheck& check) const {
  FailureReport report;
  report.folder = (fs::path(options_.failures) / items_[index].name).string();
  report.name = items_[index].name;
  report.trace = items_[index].path.string();
  report.frames = frames_;
  report.replay_options = options_.physics.value_or(true) ? "" : " --no-physics";
  if (!options_.knowledge.empty()) report.replay_options += " --knowledge " + shell_word(options_.knowledge);
  if (!options_.language.empty()) report.replay_options += " --language " + shell_word(options_.language);
  for (const auto& [name, value] : options_.settings.items())
    report.replay_options += " --set " + shell_word(name + "=" + compact(value));
  return write_failure(report, check);
}

void Checking::finish(std::size_t index, Finding finding) {
  const std::lock_guard lock(mutex_);
  finding.told.path = items_[index].path.string();
  findings_[index] = std::move(finding);
  progress_.show(index, 1);
  progress_.clear();
  const auto& traced = findings_[index]->trace;
  if (traced && traced->warning && warned_.insert(traced->warning->text()).second) report_warning(*traced->warning);
  for (; printed_ < items_.size() && findings_[printed_]; ++printed_) tell(findings_[printed_]->told, options_.github);
  std::fflush(stdout);
}

void tell(const CheckCase& one, bool github) {
  for (const auto& problem : one.problems) put(stderr, printable_line(problem.text()) + "\n");
  const auto line = printable_line(line_of(one));
  const auto word = std::min(line.find(' '), line.size());
  fmt::print("{}{}\n", verdict_word(line.substr(0, word), one.status == exit_done), line.substr(word));
  if (!one.page.empty()) fmt::print("     see {}\n", printable_line(one.page));
  if (github) fmt::print("{}", github_annotations(one));
}

}  // namespace continua
