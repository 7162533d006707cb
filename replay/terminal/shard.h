// Work that is shared by several processes, on one machine or many: which part is this one's, and a report of it that
// is read again when all parts are told as one.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "continua/core/result.h"

namespace continua {

/// One part of several of about equal size: each `count`-th item from `index` on.
struct Shard {
  std::size_t index = 1, count = 1;  ///< index from 1

  /// `item`: from 0.
  bool has(std::size_t item) const { return item % count == index - 1; }
  /// How many of so many items it has.
  std::size_t share(std::size_t items) const;
};

/// "2/4", or "auto": what Slurm's job arrays, GitLab or CircleCI tell a task by its environment. An error of one
/// clause.
Result<Shard> parse_shard(const std::string& text);
/// The same with another environment: the value of a variable, null if it is not set.
Result<Shard> parse_shard(const std::string& text, const std::function<const char*(const char*)>& environment);

inline constexpr std::size_t most_shards = 10000;

/// A report of a shard of so many items, by the name of its file.
struct ShardOf {
  std::string name;
  Shard shard;
  std::size_t items = 0;  ///< of all shards together
};

struct ShardPlaces {
  std::vector<std::optional<std::size_t>> report_of;  ///< of each shard, the number of its report
  std::vector<Error> problems;                        ///< shards that are missing, doubled or of another run
};

/// Which of the reports, of which there is at least one, belongs to which shard. `noun` names an item in errors.
ShardPlaces places_of(const std::vector<ShardOf>& reports, const std::string& noun);

/// The part of a command's output that one shard wrote.
struct ShardReport {
  std::string command;
  Shard shard;
  std::size_t items = 0;          ///< of all shards together
  int status = 0;                 ///< an ExitStatus
  std::vector<std::string> told;  ///< of each of its items, the part of the output
};

/// {"shards": 1, "command", "shard": [I, N], "items", "status", "told": [TEXT, …]}.
std::string text_of(const ShardReport& report);

/// Reads the output of text_of(). `name` stands for the file in errors.
Result<ShardReport> read_shard_report(std::string_view text, const std::string& name);

/// The parts that all shards wrote, as one process has them.
struct MergedShards {
  std::vector<std::string> told;  ///< in the order of the items; the items of missing shards are left out
  int status = 0;                 ///< the worst; exit_impossible if a shard is missing, doubled or of another run
};

/// From the files of the shards' reports; `paths` has at least one. Reports shards that are missing, doubled or of
/// another run. Error: a file is no report of that command.
Result<MergedShards> merge_shards(const std::string& command, const std::vector<std::string>& paths);

}  // namespace continua
