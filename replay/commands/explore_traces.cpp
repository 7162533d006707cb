#include "continua/replay/commands/explore_traces.h"

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/core/scratch_space.h"
#include "continua/replay/commands/moved_paths.h"
#include "continua/replay/commands/setting_options.h"
#include "continua/replay/experiment/trace_search.h"
#include "continua/replay/session/shelf.h"
#include "continua/replay/trace/trace_name.h"

namespace continua {
namespace fs = std::filesystem;
namespace {

// Writes a trace of no events, from which a session is loaded.
Outcome write_empty_trace(const ExploreTracesOptions& options, const std::string& path) {
  // Files are told from here.
  const auto named = [](const std::string& name) {
    return fs::exists(name) ? fs::absolute(name).lexically_normal().string() : name;
  };
  Trace trace;
  trace.header.scene = named(options.replay.scene);
  trace.header.machine = named(options.replay.machine);
  trace.header.language = options.replay.language;
  trace.header.seed = options.seed;
  return write_file(path, write_trace(trace));
}

// Asked before each run.
std::function<bool()> enough_after(const ExploreTracesOptions& options) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(options.time_s);
  return [end, left = options.runs, counts = options.runs > 0]() mutable {
    return counts ? left-- <= 0 : std::chrono::steady_clock::now() >= end;
  };
}

// Writes findings as traces and tells them; the first fault of writing is kept.
class Keeper {
 public:
  Keeper(const ExploreTracesOptions& options, const std::string& from) : options_(options), from_(from) {}

  void keep(const SearchFinding& finding) {
    const auto path = (fs::path(options_.output) /
                       fmt::format("{}-{}{}", finding.fault.kind, ++counts_[finding.fault.kind], trace_ending))
                          .string();
    if (!problem_) problem_ = write_moved(finding.trace, from_, path, options_.replay.knowledge);
    fmt::print("{}: {}, {} -> {}\n", finding.fault.kind, printable_line(finding.fault.place),
               counted(finding.trace.events.size() - 1, "turn"), printable_line(path));
  }

  const Outcome& problem() const { return problem_; }

 private:
  const ExploreTracesOptions& options_;
  const std::string& from_;
  std::map<std::string, int> counts_;
  Outcome problem_;
};

Result<SearchSummary> explore(const ExploreTracesOptions& options) {
  const auto folder = ScratchSpace::make();
  if (!folder) return folder.error();
  const auto path = (folder->path() / "talk.trace.jsonl").string();
  if (auto unwritten = write_empty_trace(options, path)) return *std::move(unwritten);
  std::error_code problem;
  fs::create_directories(options.output, problem);
  if (problem) return Error{options.output, fmt::format("cannot be made a folder: {}", problem.message())};
  auto replay = options.replay;
  replay.scene.clear();
  replay.machine.clear();
  replay.shelf = std::make_shared<Shelf>();
  replay.physics = false;
  auto kinematic = Session::load(path, replay);
  if (!kinematic) return kinematic.error();
  std::optional<Session> physics;
  if (options.compare) {
    replay.physics = true;
    auto session = Session::load(path, replay);
    if (!session) return session.error();
    physics = std::move(*session);
  }
  Keeper keeper(options, path);
  SearchOptions search;
  search.seed = options.seed;
  search.guided = options.guided;
  search.enough = enough_after(options);
  search.tell = [&](const SearchFinding& finding) { keeper.keep(finding); };
  auto found = search_traces(*kinematic, physics ? &*physics : nullptr, search);
  if (keeper.problem()) return *keeper.problem();
  return found;
}

}  // namespace

int run_explore_traces(const ExploreTracesOptions& options) {
  const auto found = explore(options);
  if (!found) return report(found.error()), exit_impossible;
  fmt::print("{}, {} reached, {}\n", counted(found->runs, "conversation"), counted(found->reached, "thing"),
             counted(found->findings.size(), "finding"));
  return found->findings.empty() ? exit_done : exit_no;
}

void describe_explore_traces(CLI::App& command, ExploreTracesOptions& options) {
  command.add_option("SCENE", options.replay.scene, "a name or an MJCF file")->required();
  command.add_option("--machine", options.replay.machine, "a name or a machine file")->required();
  command.add_option("--time", options.time_s, "seconds to look; otherwise 60")->check(CLI::Range(0.1, 1e6));
  command.add_option("--runs", options.runs, "so many conversations instead: the same each time")
      ->check(CLI::Range(1, 100'000'000));
  command.add_option("-o,--output", options.output,
                     "a folder for a trace of each finding, KIND-1.trace.jsonl, …; otherwise the current one");
  command.add_option("--seed", options.seed, "of the search");
  command.add_flag("--guided,!--no-guided", options.guided,
                   "go on from conversations that reach something new; otherwise each is drawn anew");
  command.add_flag("--compare,!--no-compare", options.compare,
                   "replay conversations that reach something new with physics too");
  add_set_option(command, options.replay.settings);
  command.add_option("--language", options.replay.language, "of speech; otherwise the machine's");
  command.add_option("--knowledge", options.replay.knowledge, "folder of all knowledge; otherwise the program's");
  command.footer(
      "Conversations are made of the lexicon's examples, of inputs that the machine's arcs name, of gestures and of "
      "pointing at things. Those that reach a transition, or a pair of them, that none reached before are gone on "
      "from. Findings: a problem; refusals, three words or gestures in a row without any effect; dead, a state in "
      "which "
      "so are all that follow; wordless, an act without a word; worlds, other acts with physics. Each is kept once, "
      "with the fewest turns that still do it.\n"
      "Exit status: 1 if there are findings.\n"
      "Examples: continua explore-traces place_setting --machine interaction --time 60 -o found\n"
      "          continua explore-traces staircase --machine edited.json --runs 2000 --no-compare");
}

}  // namespace continua
