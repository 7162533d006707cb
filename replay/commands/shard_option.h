// --shard I/N, the same in each command whose work can be shared.
#pragma once

#include "continua/replay/terminal/shard.h"

namespace CLI {
class App;
}

namespace continua {

/// Adds the option, which puts its value into `shard`.
void add_shard_option(CLI::App& command, Shard& shard);

}  // namespace continua
