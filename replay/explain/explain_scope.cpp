#include "continua/replay/explain/explain_scope.h"

#include <algorithm>

#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_sources.h"

namespace continua {

namespace {

// Links of a chain whose records are read: no log of a machine that halts comes near it.
constexpr std::size_t most_read = 1000;

}  // namespace

ExplainScope::ExplainScope(const RunIndex& run, std::size_t n) : run_(run) {
  for (std::optional<std::size_t> at = n; at; at = run.cause(*at)) chain_.push_back(*at);
  RunSources sources(run);  // as far as its lines can be read
  const std::vector<std::size_t> near(chain_.begin(), chain_.begin() + std::min(chain_.size(), most_read));
  for (const auto at : near) {
    if (log::is<log::Input>(run.kind(at))) inputs_.push_back(at);
    sources.add(at, record(at));
  }
  // Applications on the way drew on more inputs than the record itself may name.
  for (const auto at : run.of_kind(log::Application::kind.name)) {
    if (at > n) break;
    if (const auto cause = run.cause(at); cause && std::binary_search(near.rbegin(), near.rend(), *cause))
      sources.add(at, record(at));
  }
  inputs_.insert(inputs_.end(), sources.inputs().begin(), sources.inputs().end());
  std::sort(inputs_.begin(), inputs_.end());
  inputs_.erase(std::unique(inputs_.begin(), inputs_.end()), inputs_.end());

  // The turn of each record, in one pass: a cause comes before its consequences.
  std::vector<std::int64_t> turn(n + 1, -1);
  for (std::size_t at = 0; at <= n; ++at) {
    if (log::is<log::Input>(run.kind(at)))
      turn[at] = static_cast<std::int64_t>(at);
    else if (const auto cause = run.cause(at))
      turn[at] = turn[*cause];
    if (turn[at] < 0) continue;
    const auto input = static_cast<std::size_t>(turn[at]);
    if (std::binary_search(inputs_.begin(), inputs_.end(), input)) turns_[input].push_back(at);
  }
}

const Json& ExplainScope::record(std::size_t n) {
  const auto found = records_.find(n);
  if (found != records_.end()) return found->second;
  auto read = run_.record(n);
  return records_.emplace(n, read ? *std::move(read) : Json::object()).first->second;
}

const RunWords& ExplainScope::words() {
  if (!words_) words_.emplace(run_);
  return *words_;
}

std::optional<std::size_t> ExplainScope::input_of(std::size_t n) const {
  for (std::optional<std::size_t> at = n; at; at = run_.cause(*at))
    if (log::is<log::Input>(run_.kind(*at))) return at;
  return std::nullopt;
}

std::vector<std::size_t> ExplainScope::of_turn(std::size_t input, std::string_view kind) const {
  std::vector<std::size_t> found;
  if (const auto turn = turns_.find(input); turn != turns_.end())
    for (const auto at : turn->second)
      if (run_.kind(at) == kind) found.push_back(at);
  return found;
}

std::vector<std::size_t> ExplainScope::latest(std::string_view kind) const {
  std::vector<std::size_t> found;
  for (const auto& [input, turn] : turns_)
    for (const auto at : turn)
      if (run_.kind(at) == kind) found.push_back(at);
  std::sort(found.rbegin(), found.rend());
  return found;
}

std::vector<std::size_t> record_numbers(const Json& object, const char* key, std::size_t before) {
  std::vector<std::size_t> numbers;
  const auto& list = member_of(object, key);
  if (!list.is_array()) return numbers;
  for (const auto& one : list)
    if (one.is_number_unsigned() && one.get<std::size_t>() < before) numbers.push_back(one.get<std::size_t>());
  return numbers;
}

Json header_member(const RunIndex& run, const char* name) {
  const auto& header = run.header();
  return header ? member_of(*header, name) : Json();
}

}  // namespace continua
