#include "continua/replay/commands/sweep_run.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "continua/core/digest.h"
#include "continua/knowledge_files/data_paths.h"
#include "continua/replay/session/version.h"
#include "continua/replay/sweep/sweep_result.h"
#include "continua/replay/terminal/shell_word.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

// Names and contents of all files below the folder, in order.
Outcome add_folder(RunningDigest& digest, const fs::path& folder) {
  std::vector<std::string> files;
  std::error_code problem;
  for (auto entry = fs::recursive_directory_iterator(folder, problem); !problem && entry != fs::end(entry);
       entry.increment(problem))
    if (entry->is_regular_file()) files.push_back(fs::relative(entry->path(), folder).generic_string());
  if (problem) return Error{folder.string(), "cannot be read: " + problem.message()};
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    const auto content = read_file((folder / file).string());
    if (!content) return content.error();
    digest.add(fmt::format("{} {}\n", file, continua::digest(*content)));
  }
  return std::nullopt;
}

// A value as --set reads it.
std::string setting(const std::string& name, const Json& value) {
  const auto* text = value.get_ptr<const std::string*>();
  return " --set " + shell_word(name + "=" + (text && !Json::accept(*text) ? *text : compact(value)));
}

std::string command_of(const ReplayOptions& options) {
  std::string text = options.physics ? "" : "--no-physics";
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) text += fmt::format(" --{} {}", name, shell_word(value));
  };
  if (options.variant != Variant::free) add("variant", name_of(options.variant));
  add("machine", options.machine);
  add("scene", options.scene);
  add("weights", options.weights);
  add("language", options.language);
  add("knowledge", options.knowledge);
  for (const auto& [name, value] : options.settings.items()) text += setting(name, value);
  return text;
}

Result<SweptTrace> counts_of(const std::string& trace, Session& session) {
  std::ostream nowhere(nullptr);
  const auto summary = session.run(nowhere);
  if (summary.stopped) return *summary.stopped;
  SweptTrace swept{trace,
                   summary.inputs,
                   summary.refusals,
                   summary.utterances,
                   summary.acts,
                   summary.acts_done,
                   summary.expectations,
                   summary.expectations_met,
                   summary.problems,
                   {}};
  if (session.trace().observes())
    for (const auto& episode : summary.episodes) swept.score.add(episode);
  return swept;
}

}  // namespace

Result<SweepGiven> sweep_given(const std::vector<std::string>& traces, const ReplayOptions& options) {
  SweepGiven given{traces, options, command_of(options), {}};
  given.options.episodes = true;
  given.options.shelf = std::make_shared<Shelf>();
  RunningDigest digest;
  digest.add(version_text() + "\n" + given.with + "\n");
  const auto data = find_data_paths(options.knowledge);
  if (!data) return data.error();
  for (const auto& folder : {data->knowledge, data->mjcf})
    if (auto problem = add_folder(digest, folder)) return *std::move(problem);
  for (const auto& trace : traces) {
    const auto session = Session::load(trace, given.options);
    if (!session) return session.error();
    digest.add(trace + "\n");
    for (const auto& file : session->files()) {
      std::error_code unknown;
      if (!fs::is_regular_file(file, unknown)) continue;  // a name that stands for one of the others, or for none
      const auto content = read_file(file);
      if (!content) return content.error();
      digest.add(continua::digest(*content));
    }
  }
  given.digest = digest.text();
  return given;
}

Result<Json> swept(const SweepGiven& given, const SweepPoint& point) {
  auto options = given.options;
  for (const auto& [name, value] : point.set.items()) options.settings[name] = value;
  if (!point.policy.empty()) options.choice = parse_choice(point.policy);
  if (point.seed) options.seed = point.seed;
  std::vector<SweptTrace> traces;
  for (const auto& trace : given.traces) {
    auto session = Session::load(trace, options);
    if (!session) return session.error();
    const auto counts = counts_of(trace, *session);
    if (!counts) return counts.error();
    traces.push_back(*counts);
  }
  auto line = point.json();
  auto with = given.with;
  for (const auto& [name, value] : point.set.items()) with += setting(name, value);
  if (!point.policy.empty()) with += " --choice " + point.policy;
  if (point.seed) with += fmt::format(" --seed {}", *point.seed);
  line["with"] = with;
  line["figures"] = figures_of(traces);
  for (const auto& trace : traces) line["traces"].push_back(trace.json());
  return line;
}

}  // namespace continua
