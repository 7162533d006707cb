// Work that is shared by several processes, on one machine or many: which part is this one's, and a report of it that
// is read again when all parts are told as one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

/// One part of several.
struct Shard {
  std::size_t index = 1, count = 1;  ///< index from 1
};

/// The items of a shard, by their numbers from 0, ascending. The dearest is dealt first, and each goes to the shard
/// that has least yet (of equals the one with fewer items, then the first), so that shards end together. `costs`: of
/// each item, in any unit. The same costs give the same items, everywhere.
std::vector<std::size_t> dealt(const Shard& shard, const std::vector<std::uint64_t>& costs);

/// The expected cost of work on each file: its bytes; of a folder, those of all files below it.
std::vector<std::uint64_t> costs_of(const std::vector<std::string>& paths);

/// "2/4", or "auto": what Slurm's job arrays, GitLab or CircleCI tell a task by its environment. An error of one
/// clause.
Result<Shard> parse_shard(const std::string& text);
/// The same with another environment: the value of a variable, null if it is not set.
Result<Shard> parse_shard(const std::string& text, const std::function<const char*(const char*)>& environment);

inline constexpr std::size_t most_shards = 10000;
inline constexpr std::size_t most_items = 10'000'000;  ///< that a report may tell of

/// The items of a report, by the name of its file.
struct ShardOf {
  std::string name;
  Shard shard;
  std::size_t items = 0;             ///< of all shards together
  std::vector<std::size_t> numbers;  ///< of its items, from 0, ascending
};

struct ShardPlaces {
  struct Place {
    std::size_t report = 0, among_its = 0;  ///< the number of the report; the item's place there
  };
  std::vector<std::size_t> reports;         ///< that count: one for each shard that is there, in their order
  std::vector<std::optional<Place>> items;  ///< of each item
  std::vector<Error> problems;              ///< shards that are missing, doubled or of another run; items likewise
};

/// Where each item is in the reports, of which there is at least one. `noun` names an item in errors.
ShardPlaces places_of(const std::vector<ShardOf>& reports, const std::string& noun);

/// A report's "shard": [I, N].
Result<Shard> read_shard(const LocatedJson& report);

/// The numbers of a report's items, from 0: its member "numbers", from 1, as many as its list `told` has entries. A
/// report of an earlier version has no such member: each N-th item was the shard's, from the I-th on.
Result<std::vector<std::size_t>> read_item_numbers(const LocatedJson& report, const Shard& shard, std::size_t items,
                                                   const std::string& told);

/// Numbers from 1, for a report.
Json json_of_item_numbers(const std::vector<std::size_t>& numbers);

/// The part of a command's output that one shard wrote.
struct ShardReport {
  std::string command;
  Shard shard;
  std::size_t items = 0;             ///< of all shards together
  std::vector<std::size_t> numbers;  ///< of its items, from 0, ascending
  int status = 0;                    ///< an ExitStatus
  std::vector<std::string> told;     ///< of each of its items, the part of the output
};

/// {"shards": 1, "command", "shard": [I, N], "items", "numbers", "status", "told": [TEXT, …]}.
std::string text_of(const ShardReport& report);

/// Reads the output of text_of(). `name` stands for the file in errors.
Result<ShardReport> read_shard_report(std::string_view text, const std::string& name);

/// The parts that all shards wrote, as one process has them.
struct MergedShards {
  std::vector<std::string> told;  ///< in the order of the items; the items of missing shards are left out
  int status = 0;                 ///< the worst; exit_impossible if a shard is missing, doubled or of another run
};

/// From the files of the shards' reports; `paths` has at least one. Reports shards that are missing, doubled or of
/// another run, and items likewise. Error: a file is no report of that command.
Result<MergedShards> merge_shards(const std::string& command, const std::vector<std::string>& paths);

}  // namespace continua
