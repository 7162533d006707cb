#include "continua/replay/annotation/annotations.h"

#include <algorithm>
#include <array>

#include "continua/core/trimmed.h"

namespace continua {
namespace {

// Tiers from top to bottom; all others follow.
constexpr std::array<std::string_view, 13> tier_order = {
    "human speech",     "human words",     "human gesture", "human pointing", "human gaze",
    "avatar speech",    "avatar gesture",  "avatar act",    "state",          "observed speech",
    "observed gesture", "observed action", "stack"};

auto place_of(const Tier& tier) { return std::find(tier_order.begin(), tier_order.end(), tier.name); }

}  // namespace

std::int64_t milliseconds(SimTime t) { return (t.us + 500) / 1000; }

std::string label_of(std::string_view text) {
  std::string label;
  for (const char c : text) label += static_cast<unsigned char>(c) < ' ' || c == '\x7f' ? ' ' : c;
  return std::string(trimmed(label, " "));
}

TierMaker::Row& TierMaker::row(const std::string& name) {
  const auto found = std::find_if(rows_.begin(), rows_.end(), [&](const Row& each) { return each.name == name; });
  if (found != rows_.end()) return *found;
  rows_.push_back({name, {}});
  return rows_.back();
}

void TierMaker::add(const std::string& tier, std::size_t n, const Stretch& stretch, std::string value, Json event,
                    std::size_t line) {
  row(tier).entries.push_back({n, line, stretch, std::move(value), std::move(event)});
}

void TierMaker::end_last(const std::string& tier, SimTime until) {
  auto& entries = row(tier).entries;
  if (!entries.empty()) entries.back().stretch.until = until;
}

std::vector<Annotation> TierMaker::laid_out(std::vector<Entry> entries) {
  std::stable_sort(entries.begin(), entries.end(),
                   [](const Entry& a, const Entry& b) { return a.stretch.from < b.stretch.from; });
  std::vector<Annotation> annotations;
  for (auto& entry : entries) {
    const auto& [from, until, shown] = entry.stretch;
    Annotation next{entry.n, milliseconds(from), milliseconds(until.value_or(from + shown)), label_of(entry.value)};
    if (!annotations.empty()) {
      auto& last = annotations.back();
      if (next.begin_ms <= last.begin_ms && entry.event.is_null() && last.event.is_null()) {
        last.value += "; " + next.value;
        last.end_ms = std::max(last.end_ms, next.end_ms);
        continue;
      }
      next.begin_ms = std::max(next.begin_ms, last.begin_ms + 1);
      last.end_ms = std::min(last.end_ms, next.begin_ms);
    }
    next.end_ms = std::max(next.end_ms, next.begin_ms + 1);
    if (!entry.event.is_null()) next.event = {{"line", entry.line}, {"event", std::move(entry.event)}};
    annotations.push_back(std::move(next));
  }
  for (auto& each : annotations)
    if (!each.event.is_null()) each.event["at"] = {each.begin_ms, each.end_ms};
  return annotations;
}

std::vector<Tier> TierMaker::finish() {
  std::vector<Tier> tiers;
  for (auto& each : rows_) {
    const auto who = each.name.substr(0, each.name.find(' '));
    const bool person = who == "human" || who == "avatar";
    tiers.push_back({each.name, person ? who : "", laid_out(std::move(each.entries))});
  }
  std::stable_sort(tiers.begin(), tiers.end(), [](const Tier& a, const Tier& b) { return place_of(a) < place_of(b); });
  return tiers;
}

}  // namespace continua
