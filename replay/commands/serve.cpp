#include "replay/commands/serve.h"

#include <pthread.h>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <csignal>
#include <filesystem>
#include <thread>

#include "replay/inspector_server.h"

namespace continua {

int run_serve(const ServeOptions& options) {
  for (const auto& path : options.paths)
    if (!std::filesystem::exists(path))
      return report({path, "does not exist; expected a run log or a folder with run logs"}), exit_impossible;

  // Signals are taken by one thread that waits for them, so that stopping needs nothing a signal handler may not do.
  sigset_t stops;
  sigemptyset(&stops);
  sigaddset(&stops, SIGINT);
  sigaddset(&stops, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &stops, nullptr);

  InspectorServer server(options.paths.empty() ? std::vector<std::string>{"."} : options.paths);
  const auto port = server.listen(options.address, options.port);
  if (!port) return report(port.error()), exit_impossible;
  fmt::print("The inspector is at http://{}:{}/ (Ctrl-C ends it)\n", options.address, *port);
  std::fflush(stdout);
  std::thread waiting([&] {
    int signal = 0;
    sigwait(&stops, &signal);
    server.stop();
  });
  server.run();
  pthread_kill(waiting.native_handle(), SIGTERM);  // in case the server ended by itself
  waiting.join();
  return exit_done;
}

void add_serve_command(CLI::App& program, Run& run) {
  auto* command = program.add_subcommand("serve", "Show runs in a browser");
  auto options = std::make_shared<ServeOptions>();
  command->add_option("PATH", options->paths, "run logs and folders of them; otherwise this folder");
  command->add_option("--port", options->port, "0 takes a free one")
      ->check(CLI::Range(0, 65535))
      ->capture_default_str();
  command->add_option("--bind", options->address, "address to listen on")->capture_default_str();
  command->footer("Example: continua serve runs --port 8080");
  command->callback([options, &run] { run = [options] { return run_serve(*options); }; });
}

}  // namespace continua
