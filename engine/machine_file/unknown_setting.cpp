#include "continua/machine_file/unknown_setting.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "continua/core/counted.h"
#include "continua/core/located_json.h"

namespace continua {
namespace {

constexpr std::size_t longest_name = 200;  ///< of one that is compared; real names are shorter
constexpr std::string_view of_weight = "weights.", of_gate = "gate.", of_belief = "belief.";

// The row and the level of "3.1", counted from 1.
std::optional<std::pair<std::size_t, std::size_t>> row_and_level(std::string_view text) {
  std::size_t row = 0, level = 0;
  const auto *begin = text.data(), *end = begin + text.size();
  const auto first = std::from_chars(begin, end, row);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != '.') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, level);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  return std::pair(row, level);
}

std::string reason_of_gate(const Machine& machine, const std::string& state) {
  const auto found =
      std::find_if(machine.states.begin(), machine.states.end(), [&](const auto& one) { return one.name == state; });
  if (found == machine.states.end()) return fmt::format("there is no state {}", in_quotes(state));
  if (!found->gate) return fmt::format("the state {} has no gate", in_quotes(state));
  return fmt::format("the gate of {} has not one number alone", in_quotes(state));
}

std::string reason_of_belief(const Machine& machine, std::string_view place) {
  const auto& evidence = machine.beliefs.evidence;
  const auto told = row_and_level(place);
  if (!told) return "it is no belief.ROW.LEVEL";
  if (told->first < 1 || told->first > evidence.size())
    return fmt::format("there {} {} of evidence", evidence.size() == 1 ? "is" : "are", counted(evidence.size(), "row"));
  return fmt::format("row {} of the evidence has {}", told->first,
                     counted(evidence[told->first - 1].levels.size(), "level"));
}

std::string reason_of(const Machine& machine, const std::string& name) {
  if (name.starts_with(of_gate)) return ": " + reason_of_gate(machine, name.substr(of_gate.size()));
  if (name.starts_with(of_belief)) return ": " + reason_of_belief(machine, name.substr(of_belief.size()));
  if (name.starts_with(of_weight))
    return fmt::format(": there is no transition {}", in_quotes(name.substr(of_weight.size())));
  return "";
}

// The level that stands nearest in the rows: letters do not tell how far numbers are apart.
std::string nearest_level(const Machine& machine, const std::string& name) {
  const auto& evidence = machine.beliefs.evidence;
  const auto told = name.starts_with(of_belief) ? row_and_level(name.substr(of_belief.size())) : std::nullopt;
  if (!told || evidence.empty()) return "";
  const auto row = std::clamp<std::size_t>(told->first, 1, evidence.size());
  const auto levels = evidence[row - 1].levels.size();
  return levels == 0 ? "" : fmt::format("{}{}.{}", of_belief, row, std::clamp<std::size_t>(told->second, 1, levels));
}

// Of the same kind, that is, with the same text before the first dot.
std::string nearest_of_kind(const std::string& name, const std::vector<std::string>& names) {
  if (name.size() > longest_name) return "";
  const auto kind = name.substr(0, name.find('.') + 1);
  const std::string* nearest = nullptr;
  std::size_t least = 0;
  for (const auto& one : names) {
    if (!one.starts_with(kind)) continue;
    const auto distance = edit_distance(name, one);
    if (nearest && distance >= least) continue;
    nearest = &one;
    least = distance;
  }
  return nearest ? *nearest : "";
}

}  // namespace

std::string unknown_setting(const Machine& machine, const std::string& name, const std::vector<std::string>& names) {
  auto nearest = nearest_level(machine, name);
  if (nearest.empty()) nearest = nearest_of_kind(name, names);
  const auto hint =
      nearest.empty() ? did_you_mean(name, names) : fmt::format(" (did you mean {}?)", in_quotes(nearest));
  return fmt::format("the machine {} has no value {} that can be set{}{}", machine.name, in_quotes(name),
                     reason_of(machine, name), hint);
}

}  // namespace continua
