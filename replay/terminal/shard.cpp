#include "continua/replay/terminal/shard.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <queue>
#include <tuple>

#include <fmt/format.h>

#include "continua/core/located_json.h"
#include "continua/replay/terminal/terminal.h"

namespace continua {
namespace fs = std::filesystem;
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

std::uint64_t bytes_of(const fs::path& path) {
  std::error_code problem;
  if (!fs::is_directory(path, problem)) {
    const auto bytes = fs::file_size(path, problem);
    return problem ? 0 : bytes;
  }
  std::uint64_t sum = 0;
  for (auto entry = fs::recursive_directory_iterator(path, problem); !problem && entry != fs::end(entry);
       entry.increment(problem))
    if (entry->is_regular_file(problem)) sum += entry->file_size(problem);
  return sum;
}

// The reports of the shards that are there, in their order.
std::vector<std::size_t> reports_that_count(const std::vector<ShardOf>& reports, const std::string& noun,
                                            std::vector<Error>& problems) {
  const auto& first = reports.front();
  std::vector<std::optional<std::size_t>> report_of(first.shard.count);
  for (std::size_t i = 0; i < reports.size(); ++i) {
    const auto& [name, shard, items, numbers] = reports[i];
    if (shard.count != first.shard.count || items != first.items) {
      problems.push_back(
          {name, fmt::format("is shard {}; expected one of {} of {} as in {}", counted_items(reports[i], noun),
                             first.shard.count, counted(first.items, noun), first.name)});
      continue;
    }
    auto& place = report_of[shard.index - 1];
    if (place)
      problems.push_back({name, fmt::format("is shard {}/{}, and so is {}; expected each once", shard.index,
                                            shard.count, reports[*place].name)});
    else
      place = i;
  }
  std::vector<std::size_t> there;
  for (std::size_t shard = 0; shard < report_of.size(); ++shard)
    if (report_of[shard])
      there.push_back(*report_of[shard]);
    else
      problems.push_back({"--merge", fmt::format("shard {}/{} is missing", shard + 1, report_of.size())});
  return there;
}

}  // namespace

std::vector<std::size_t> dealt(const Shard& shard, const std::vector<std::uint64_t>& costs) {
  std::vector<std::size_t> dearest_first(costs.size());
  std::iota(dearest_first.begin(), dearest_first.end(), std::size_t{0});
  std::stable_sort(dearest_first.begin(), dearest_first.end(),
                   [&](std::size_t a, std::size_t b) { return costs[a] > costs[b]; });
  using Load = std::tuple<std::uint64_t, std::size_t, std::size_t>;  // the cost, the items, the shard from 1
  std::priority_queue<Load, std::vector<Load>, std::greater<>> least;
  for (std::size_t index = 1; index <= shard.count; ++index) least.emplace(0, 0, index);
  std::vector<std::size_t> items;
  for (const auto item : dearest_first) {
    const auto [cost, count, index] = least.top();
    least.pop();
    least.emplace(cost + costs[item], count + 1, index);
    if (index == shard.index) items.push_back(item);
  }
  std::sort(items.begin(), items.end());
  return items;
}

std::vector<std::uint64_t> costs_of(const std::vector<std::string>& paths) {
  std::vector<std::uint64_t> costs;
  for (const auto& path : paths) costs.push_back(bytes_of(path));
  return costs;
}

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
  constexpr const char* why = "the inputs differed where the shards ran";
  ShardPlaces all;
  all.reports = reports_that_count(reports, noun, all.problems);
  all.items.resize(reports.front().items);
  for (const auto report : all.reports) {
    const auto& numbers = reports[report].numbers;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      auto& place = all.items[numbers[i]];
      if (place)
        all.problems.push_back(
            {reports[report].name, fmt::format("has {} {}, and so has {}; expected each once: {}", noun, numbers[i] + 1,
                                               reports[place->report].name, why)});
      else
        place = ShardPlaces::Place{report, i};
    }
  }
  if (all.reports.size() < reports.front().shard.count) return all;
  for (std::size_t item = 0; item < all.items.size(); ++item)
    if (!all.items[item])
      all.problems.push_back({"--merge", fmt::format("no report has {} {}: {}", noun, item + 1, why)});
  return all;
}

Result<Shard> read_shard(const LocatedJson& report) {
  const auto shard = report.root().value("shard", Json());
  const auto is_count = [](const Json& json) { return json.is_number_unsigned() && json > 0 && json <= most_shards; };
  if (!shard.is_array() || shard.size() != 2 || !is_count(shard[0]) || !is_count(shard[1]) || shard[0] > shard[1])
    return report.error("/shard", fmt::format("found {}; expected \"shard\": [I, N], I from 1 to N", compact(shard)));
  return Shard{shard[0].get<std::size_t>(), shard[1].get<std::size_t>()};
}

Result<std::vector<std::size_t>> read_item_numbers(const LocatedJson& report, const Shard& shard, std::size_t items,
                                                   const std::string& told) {
  const auto& root = report.root();
  const auto wrong = [&](const std::string& place, const std::string& sentence) {
    return report.error("/" + place, sentence);
  };
  if (items > most_items) return wrong("", fmt::format("found {} items; expected at most {}", items, most_items));
  const bool numbered = root.contains("numbers");
  if (numbered && !root["numbers"].is_array()) return wrong("numbers", "expected a list of numbers");
  const auto expected = numbered ? root["numbers"].size() : (items + shard.count - shard.index) / shard.count;
  if (root[told].size() != expected)
    return wrong(told, fmt::format("found {}; expected {} for shard {}/{} of {}", root[told].size(), expected,
                                   shard.index, shard.count, counted(items, "item")));
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < expected; ++i) {
    const auto number = numbered ? root["numbers"][i] : Json(shard.index + i * shard.count);
    if (!number.is_number_unsigned() || number > items || number < 1 + (numbers.empty() ? 0 : numbers.back() + 1))
      return wrong("numbers",
                   fmt::format("found {}; expected numbers from 1 to {}, ascending", compact(number), items));
    numbers.push_back(number.get<std::size_t>() - 1);
  }
  return numbers;
}

Json json_of_item_numbers(const std::vector<std::size_t>& numbers) {
  Json json = Json::array();
  for (const auto number : numbers) json.push_back(number + 1);
  return json;
}

std::string text_of(const ShardReport& report) {
  const Json json{{"shards", 1},
                  {"command", report.command},
                  {"shard", {report.shard.index, report.shard.count}},
                  {"items", report.items},
                  {"numbers", json_of_item_numbers(report.numbers)},
                  {"status", report.status},
                  {"told", report.told}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<ShardReport> read_shard_report(std::string_view text, const std::string& name) {
  const auto document = LocatedJson::parse(text, name);
  if (!document) return document.error();
  const auto& root = document->root();
  if (!root.is_object() || root.value("shards", Json()) != 1)
    return document->error("", "found no report of a shard; expected \"shards\": 1");
  ShardReport report;
  const auto items = root.value("items", Json()), status = root.value("status", Json()),
             told = root.value("told", Json()), command = root.value("command", Json());
  const auto shard = read_shard(*document);
  if (!shard) return shard.error();
  report.shard = *shard;
  if (!command.is_string()) return document->error("/command", "expected the name of a command");
  report.command = command.get<std::string>();
  if (!items.is_number_unsigned()) return document->error("/items", "expected the number of items of all shards");
  report.items = items.get<std::size_t>();
  if (!status.is_number_unsigned() || status > exit_impossible) return document->error("/status", "expected 0, 1 or 2");
  report.status = status.get<int>();
  const auto is_text = [](const Json& one) { return one.is_string(); };
  if (!told.is_array() || !std::all_of(told.begin(), told.end(), is_text))
    return document->error("/told", "expected a list of texts, one for each item of the shard");
  auto numbers = read_item_numbers(*document, report.shard, report.items, "told");
  if (!numbers) return numbers.error();
  report.numbers = *std::move(numbers);
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
    shards.push_back({path, one->shard, one->items, one->numbers});
    reports.push_back(*std::move(one));
  }
  const auto places = places_of(shards, "item");
  MergedShards all;
  for (const auto& place : places.items)
    if (place) all.told.push_back(std::move(reports[place->report].told[place->among_its]));
  for (const auto& one : reports) all.status = std::max(all.status, one.status);
  for (const auto& problem : places.problems) report(problem);
  if (!places.problems.empty()) all.status = exit_impossible;
  return all;
}

}  // namespace continua
