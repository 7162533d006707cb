#include "continua/replay/commands/record.h"

#include <atomic>
#include <filesystem>
#include <thread>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/core/gzip_name.h"
#include "continua/replay/commands/setting_options.h"
#include "continua/replay/live/event_pipe.h"
#include "continua/replay/live/live_trace.h"
#include "continua/replay/server/inspector_server.h"
#include "continua/replay/server/stop_signals.h"
#include "continua/replay/trace/trace_name.h"

namespace continua {
namespace {

namespace fs = std::filesystem;

constexpr int usual_port = 8080;

// Where the traces go. The first is called as `output` says, which must not be there yet.
Outcome place_traces(const std::string& output, LiveDefaults& live) {
  if (output.empty()) return std::nullopt;
  if (is_gzip_name(output))
    return Error{output,
                 "would be packed, but each event is written at once; expected a name without .gz (continua "
                 "pack --gzip packs it afterwards)"};
  std::error_code problem;
  if (fs::is_directory(output, problem)) {
    live.folder = output;
    return std::nullopt;
  }
  const auto folder = fs::path(output).parent_path().string(), file = fs::path(output).filename().string();
  live.name = trace_name(output);
  live.ending = file.substr(live.name.size());
  live.folder = folder.empty() ? "." : folder;
  for (const auto& path : {output, (fs::path(live.folder) / (live.name + ".run.jsonl")).string()})
    if (fs::exists(path, problem)) return Error{path, "exists already; expected a new file"};
  return std::nullopt;
}

int tell(const PipeSummary& told) {
  if (!told.summary) return exit_done;
  const auto& [summary, session] = std::tie(*told.summary, *told.session.session);
  put(stderr, fmt::format("{:.1f} s, {} and {}, {} of {} acts done; {} and {}\n", summary.end.seconds(),
                          counted(told.events, "event"),
                          counted(static_cast<std::size_t>(summary.utterances), "utterance"), summary.acts_done,
                          summary.acts, session.setting().options.trace_path, session.setting().options.log_path));
  for (const auto& unmet : summary.unmet) report(unmet.error(session.setting().options.trace_path));
  if (summary.expectations_met < summary.expectations)
    report({session.setting().options.trace_path,
            fmt::format("{} of {} expectations were not met", summary.expectations - summary.expectations_met,
                        summary.expectations)});
  if (told.broke) return exit_impossible;
  return told.refused > 0 || summary.expectations_met < summary.expectations ? exit_no : exit_done;
}

}  // namespace

int run_record(const RecordOptions& given) {
  auto options = given;
  if (const auto problem = place_traces(options.output, options.live)) return report(*problem), exit_impossible;
  if (const auto& after = options.live.after; !after.empty())
    if (const auto before = read_before(after, options.live.folder); !before)
      return report(before.error()), exit_impossible;
  const bool piped = is_piped();
  options.live.say = [piped](const std::string& sentence) {
    put(piped ? stderr : stdout, sentence + "\n");
    std::fflush(stdout);
  };
  const auto sessions = LiveSessions::create(options.live);
  if (!sessions) return report(sessions.error()), exit_impossible;

  InspectorServer server({}, *sessions);
  const auto place = listen(server, options.listen, options.port.value_or(usual_port));
  if (!place && (!piped || options.port)) return report(place.error()), exit_impossible;
  if (place)
    options.live.say(fmt::format("Record at {} ({})", place->page("/live"),
                                 piped ? "events of standard input are recorded" : "Ctrl-C ends it"));
  std::atomic<bool> stopped = false;
  const StopSignals stop_signals([&] {
    stopped = true;
    (*sessions)->end();
    server.stop();
  });
  if (!piped) return server.run(), exit_done;

  std::thread serving([&] {
    if (place) server.run();
  });
  // Where a server was asked for nobody piped anything: the command was only started without a terminal.
  const auto told = pipe_events(**sessions, !options.port, stopped);
  if (!told || told->summary || !options.port) server.stop();
  serving.join();
  return told ? tell(*told) : (report(told.error()), exit_impossible);
}

void describe_record(CLI::App& command, RecordOptions& options) {
  auto& live = options.live;
  command.add_option("-o,--output", options.output,
                     "the trace, or a folder; otherwise session.trace.jsonl here. The run log is beside it");
  command.add_option("--after", live.after,
                     "a trace: the first session goes on where it ended, in its scene and with its machine");
  command.add_option("--scene", live.scene, "a name or an MJCF file; otherwise that of knowledge/live.json");
  command.add_option("--machine", live.machine, "a name or a machine file; otherwise that of knowledge/live.json");
  command.add_option("--seed", live.replay.seed, "for draws");
  add_set_option(command, live.replay.settings);
  command.add_option("--language", live.replay.language,
                     "of speech and of what the avatar says: a name in knowledge/lexicon; otherwise the machine's");
  command.add_option("--knowledge", live.replay.knowledge,
                     "folder of machines, lexicon, voxemes; otherwise the program's");
  command.add_flag_callback(
      "--no-physics", [&options] { options.live.replay.physics = false; },
      "the kinematic world, in which acts succeed at once");
  auto clock = std::make_shared<std::string>();
  command
      .add_option("--clock", *clock,
                  "what time goes by: the wall's clock, or the times that events tell; otherwise the latter if the "
                  "first event tells one")
      ->check(CLI::IsMember({"wall", "events"}));
  command.add_option("--speed", live.speed, "seconds of the session in one of the wall's clock")
      ->check(CLI::Range(0.01, 100.0))
      ->capture_default_str();
  command.add_flag("--durable", live.durable, describe_durable);
  command.add_option("--tests", live.tests, "the folder in which sessions are saved as tests")->capture_default_str();
  command.add_option("--port", options.port, "of the page; 8080, 0 takes a free one")->check(CLI::Range(0, 65535));
  describe_listening(command, options.listen);
  command.footer(
      "Events may also come through a pipe, as JSON lines of the trace format; the avatar's moves then go to standard "
      "output.\n"
      "Examples: continua record -o talk.trace.jsonl\n"
      "          continua record --after talk.trace.jsonl -o more.trace.jsonl\n"
      "          echo '{\"kind\":\"speech\",\"text\":\"The plate.\"}' | continua record -o plate.trace.jsonl\n"
      "          my_recognisers | continua record --scene workbench -o talk.trace.jsonl | my_synthesiser");
  command.callback([&options, clock] {
    if (!clock->empty()) options.live.timing = *clock == "wall" ? LiveTiming::wall : LiveTiming::events;
  });
}

}  // namespace continua
