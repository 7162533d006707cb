// --set NAME=VALUE, the same in each command that replays.
#pragma once

#include "continua/core/located_json.h"

namespace CLI {
class App;
}

namespace continua {

/// Adds the option, which puts {name: value} into `settings` (machine_settings.h). A value that has no name is an error
/// of the command line.
void add_set_option(CLI::App& command, Json& settings);

}  // namespace continua
