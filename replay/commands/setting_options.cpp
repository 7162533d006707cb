#include "continua/replay/commands/setting_options.h"

#include <CLI/CLI.hpp>

#include "continua/machine_file/machine_settings.h"

namespace continua {

void add_set_option(CLI::App& command, Json& settings) {
  command
      .add_option_function<std::vector<std::string>>(
          "--set",
          [&settings](const std::vector<std::string>& all) {
            for (const auto& each : all) {
              auto setting = read_setting(each, "--set");
              if (!setting) throw CLI::ValidationError("--set", setting.error().sentence);
              settings[setting->first] = std::move(setting->second);
            }
          },
          "NAME=VALUE, more than once if need be: a parameter of the machine, weights.ID of a transition, gate.STATE "
          "for the number in a gate, belief.ROW.LEVEL or belief.overheard")
      ->type_name("NAME=VALUE")
      ->expected(1)
      ->take_all();
}

void add_setting_options(CLI::App& command, ReplayOptions& options) {
  command.add_option("--scene", options.scene, "a name or an MJCF file; otherwise the trace's");
  command.add_option("--machine", options.machine, "a name or a machine file; otherwise the trace's");
  command.add_option("--weights", options.weights,
                     "a file of continua learn: weights and levels of evidence in place of the machine's own");
  add_set_option(command, options.settings);
  command.add_option(
      "--language", options.language,
      "of speech and of what the avatar says: a name in knowledge/lexicon; otherwise the trace's, or the machine's");
  command.add_option("--knowledge", options.knowledge, "folder of machines, lexicon, voxemes; otherwise the program's");
}

}  // namespace continua
