#include "continua/replay/commands/shard_option.h"

#include <CLI/CLI.hpp>

namespace continua {

void add_shard_option(CLI::App& command, Shard& shard) {
  command
      .add_option_function<std::string>(
          "--shard",
          [&shard](const std::string& text) {
            const auto told = parse_shard(text);
            if (!told) throw CLI::ValidationError("--shard", told.error().sentence);
            shard = *told;
          },
          "I/N: only part I of N, from 1; auto: as a task of Slurm, GitLab or CircleCI is told")
      ->type_name("I/N");
}

}  // namespace continua
