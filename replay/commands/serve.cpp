#include "continua/replay/commands/serve.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <filesystem>

#include "continua/replay/live/live_sessions.h"
#include "continua/replay/server/inspector_server.h"
#include "continua/replay/server/stop_signals.h"

namespace continua {

int run_serve(const ServeOptions& options) {
  for (const auto& path : options.paths)
    if (!std::filesystem::exists(path))
      return report({path, "does not exist; expected a run log or a folder with run logs"}), exit_impossible;

  const std::vector<std::string> paths = options.paths.empty() ? std::vector<std::string>{"."} : options.paths;
  LiveDefaults live;
  live.folder = std::filesystem::is_directory(paths.front())
                    ? paths.front()
                    : std::filesystem::path(paths.front()).parent_path().string();
  live.durable = options.durable;
  live.tests = (std::filesystem::path(live.folder) / live.tests).string();
  live.say = [](const std::string& sentence) { put(stdout, sentence + "\n"), std::fflush(stdout); };
  const auto sessions = LiveSessions::create(live);
  if (!sessions) report_warning(sessions.error());

  InspectorServer server(paths, sessions ? *sessions : nullptr);
  const auto place = listen(server, options.listen, options.port);
  if (!place) return report(place.error()), exit_impossible;
  fmt::print("The inspector is at {} (Ctrl-C ends it)\n", place->page("/"));
  std::fflush(stdout);
  const StopSignals stop_signals([&] { server.stop(); });
  server.run();
  return exit_done;
}

void describe_serve(CLI::App& command, ServeOptions& options) {
  command.add_option("PATH", options.paths, "run logs and folders of them; otherwise this folder");
  command.add_option("--port", options.port, "0 takes a free one")->check(CLI::Range(0, 65535))->capture_default_str();
  command.add_flag("--durable", options.durable, describe_durable);
  describe_listening(command, options.listen);
  command.footer("Example: continua serve runs --port 8080");
}

}  // namespace continua
