#include "continua/replay/terminal/shard.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/replay/terminal/terminal.h"

namespace continua {
namespace {

constexpr const char* by_hand = "I/N, I from 1 to N, or auto";

std::optional<std::size_t> number_of(std::string_view text) {
  std::size_t number = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

std::optional<Shard> checked(std::optional<std::size_t> index, std::optional<std::size_t> count) {
  if (!index || !count || *index < 1 || *index > *count) return std::nullopt;
  return Shard{*index, *count};
}

// The variables of a system in which a task finds its number and their count. `first`: the number of the first task, by
// the value of a variable or else as it stands.
struct System {
  const char *name, *index, *count, *first_variable;
  std::size_t first;
};

constexpr System systems[] = {
    {"Slurm", "SLURM_ARRAY_TASK_ID", "SLURM_ARRAY_TASK_COUNT", "SLURM_ARRAY_TASK_MIN", 1},
    {"GitLab", "CI_NODE_INDEX", "CI_NODE_TOTAL", nullptr, 1},
    {"CircleCI", "CIRCLE_NODE_INDEX", "CIRCLE_NODE_TOTAL", nullptr, 0},
};

Result<Shard> shard_of_task(const std::function<const char*(const char*)>& environment) {
  for (const auto& system : systems) {
    const auto *index = environment(system.index), *count = environment(system.count);
    if (!index || !count) continue;
    auto number = number_of(index);
    auto first = std::optional(system.first);
    if (const auto* told = system.first_variable ? environment(system.first_variable) : nullptr)
      first = number_of(told);
    if (number && first) number = *number - *first + 1;
    if (const auto shard = checked(number, number_of(count)); shard && first) return *shard;
    return Error{"", fmt::format("{} says that {} is {} and {} is {}; expected numbers of tasks that follow each other",
                                 system.name, system.index, in_quotes(index), system.count, in_quotes(count))};
  }
  std::string names;
  for (const auto& system : systems)
    names += fmt::format("{}{} and {}", names.empty() ? "" : ", ", system.index, system.count);
  return Error{"", fmt::format("found auto, and none of {} is set; expected I/N", names)};
}

std::string counted_items(const ShardOf& report, const std::string& noun) {
  return fmt::format("{}/{} of {}", report.shard.index, report.shard.count, counted(report.items, noun));
}

}  // namespace

std::size_t Shard::share(std::size_t items) const { return (items + count - index) / count; }

Result<Shard> parse_shard(const std::string& text, const std::function<const char*(const char*)>& environment) {
  if (text == "auto") return shard_of_task(environment);
  const auto slash = std::min(text.find('/'), text.size());
  const auto shard =
      checked(number_of(text.substr(0, slash)), number_of(text.substr(std::min(slash + 1, text.size()))));
  if (!shard || slash == text.size()) return Error{"", fmt::format("found {}; expected {}", in_quotes(text), by_hand)};
  return *shard;
}

Result<Shard> parse_shard(const std::string& text) {
  return parse_shard(text, [](const char* name) { return std::getenv(name); });
}

ShardPlaces places_of(const std::vector<ShardOf>& reports, const std::string& noun) {
  const auto& first = reports.front();
  ShardPlaces all{std::vector<std::optional<std::size_t>>(first.shard.count), {}};
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const auto& [name, shard, items] = reports[i];
    if (shard.count != first.shard.count || items != first.items) {
      all.problems.push_back(
          {name, fmt::format("is shard {}; expected one of {} of {} as in {}", counted_items(reports[i], noun),
                             first.shard.count, counted(first.items, noun), first.name)});
      continue;
    }
    auto& place = all.report_of[shard.index - 1];
    if (place)
      all.problems.push_back({name, fmt::format("is shard {}/{}, and so is {}; expected each once", shard.index,
                                                shard.count, reports[*place].name)});
    else
      place = i;
  }
  for (std::size_t shard = 0; shard < all.report_of.size(); ++shard)
    if (!all.report_of[shard])
      all.problems.push_back({"--merge", fmt::format("shard {}/{} is missing", shard + 1, all.report_of.size())});
  return all;
}

std::string text_of(const ShardReport& report) {
  const Json json{
      {"shards", 1},           {"command", report.command}, {"shard", {report.shard.index, report.shard.count}},
      {"items", report.items}, {"status", report.status},   {"told", report.told}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<ShardReport> read_shard_report(std::string_view text, const std::string& name) {
  const auto document = LocatedJson::parse(text, name);
  if (!document) return document.error();
  const auto& root = document->root();
  if (!root.is_object() || root.value("shards", Json()) != 1)
    return document->error("", "found no report of a shard; expected \"shards\": 1");
  ShardReport report;
  const auto shard = root.value("shard", Json()), items = root.value("items", Json()),
             status = root.value("status", Json()), told = root.value("told", Json()),
             command = root.value("command", Json());
  const auto is_count = [](const Json& json) { return json.is_number_unsigned() && json > 0 && json <= most_shards; };
  if (!shard.is_array() || shard.size() != 2 || !is_count(shard[0]) || !is_count(shard[1]) || shard[0] > shard[1])
    return document->error("/shard",
                           fmt::format("found {}; expected \"shard\": [I, N], I from 1 to N", compact(shard)));
  report.shard = {shard[0].get<std::size_t>(), shard[1].get<std::size_t>()};
  if (!command.is_string()) return document->error("/command", "expected the name of a command");
  report.command = command.get<std::string>();
  if (!items.is_number_unsigned()) return document->error("/items", "expected the number of items of all shards");
  report.items = items.get<std::size_t>();
  if (!status.is_number_unsigned() || status > exit_impossible) return document->error("/status", "expected 0, 1 or 2");
  report.status = status.get<int>();
  const auto is_text = [](const Json& one) { return one.is_string(); };
  if (!told.is_array() || !std::all_of(told.begin(), told.end(), is_text) ||
      told.size() != report.shard.share(report.items))
    return document->error("/told", fmt::format("expected {}, the share of shard {}/{} of {}",
                                                counted(report.shard.share(report.items), "text"), report.shard.index,
                                                report.shard.count, counted(report.items, "item")));
  report.told = told.get<std::vector<std::string>>();
  return report;
}

Result<MergedShards> merge_shards(const std::string& command, const std::vector<std::string>& paths) {
  std::vector<ShardReport> reports;
  std::vector<ShardOf> shards;
  for (const auto& path : paths) {
    const auto text = read_file(path);
    if (!text) return text.error();
    auto one = read_shard_report(*text, path);
    if (!one) return one.error();
    if (one->command != command)
      return Error{path, fmt::format("is of continua {}; expected a report of continua {}", one->command, command)};
    shards.push_back({path, one->shard, one->items});
    reports.push_back(*std::move(one));
  }
  const auto [report_of, problems] = places_of(shards, "item");
  MergedShards all;
  for (std::size_t item = 0; item < shards.front().items; ++item)
    if (const auto place = report_of[item % report_of.size()])
      all.told.push_back(std::move(reports[*place].told[item / report_of.size()]));
  for (const auto& one : reports) all.status = std::max(all.status, one.status);
  for (const auto& problem : problems) report(problem);
  if (!problems.empty()) all.status = exit_impossible;
  return all;
}

}  // namespace continua
