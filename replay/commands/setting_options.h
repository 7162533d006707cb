// Options about the setting of replays, the same in each command: scene, machine, its numbers, language, knowledge.
#pragma once

#include "continua/core/located_json.h"
#include "continua/replay/session/session.h"

namespace CLI {
class App;
}

namespace continua {

/// Adds --set NAME=VALUE, which puts {name: value} into `settings` (machine_settings.h). A value that has no name is an
/// error of the command line.
void add_set_option(CLI::App& command, Json& settings);

/// Adds --scene, --machine, --weights, --set, --language and --knowledge, which otherwise are as the trace tells.
void add_setting_options(CLI::App& command, ReplayOptions& options);

}  // namespace continua
