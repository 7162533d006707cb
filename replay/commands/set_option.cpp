#include "continua/replay/commands/set_option.h"

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

}  // namespace continua
