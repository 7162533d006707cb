#include "replay/run_pointing.h"

#include <algorithm>
#include <cctype>

#include "replay/run_brief.h"

namespace continua {
namespace {

constexpr SimTime burst_gap{500'000};          // samples farther apart are two pointings
constexpr SimTime shortest_pointing{700'000};  // of one sample, or of a gesture that ends at once
constexpr SimTime avatar_pointing{2'000'000};  // a gesture of the avatar has no end in the log

// The names that a term is made of.
std::vector<std::string> names_in(const std::string& term) {
  std::vector<std::string> names(1);
  for (const char c : term) {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '#')
      names.back() += c;
    else if (!names.back().empty())
      names.emplace_back();
  }
  return names;
}

}  // namespace

void PointingReader::input(std::size_t n, SimTime t, const Json& event) {
  const auto kind = text_of(event, "kind");
  if (kind == "pointing") {
    point(n, t, t, event);
    return;
  }
  if (kind != "gesture") return;
  const auto phase = text_of(event, "phase"), hand = text_of(event, "hand") + "/" + text_of(event, "name");
  if (const auto held = held_.find(hand); held != held_.end()) {
    auto& until = pointings_[held->second].until;
    until = std::max(until, t);
    held_.erase(held);
  }
  if (phase == "stop") return;
  const auto pointing = point(n, t, time_in(member_of(event, "until"), t), event);
  if (pointing && phase == "start") held_[hand] = *pointing;
}

/// The place in pointings_ of what the event begins or goes on with, if it points anywhere.
std::optional<std::size_t> PointingReader::point(std::size_t n, SimTime t, SimTime until, const Json& event) {
  const auto at = pointed_at(event);
  if (!at) return std::nullopt;
  const auto hand = text_of(event, "hand");
  const auto burst = bursts_.find(hand);
  // Also a gesture goes on with the samples around it, so that one hand never shows two places.
  if (burst != bursts_.end() && t - pointings_[burst->second].until <= burst_gap) {
    auto& pointing = pointings_[burst->second];
    pointing.samples.push_back({t, *at});
    pointing.until = std::max(pointing.until, until);
    pointing.records.push_back(n);
    return burst->second;
  }
  pointings_.push_back({false, t, until, {{t, *at}}, hand, "", {n}});
  return bursts_[hand] = pointings_.size() - 1;
}

void PointingReader::avatar_gesture(std::size_t n, SimTime t, const std::string& term) {
  RunPointing pointing{true, t, t + avatar_pointing, {}, "", "", {n}};
  const auto names = names_in(term);
  const auto body = std::find_if(names.begin(), names.end(), [&](const auto& name) { return bodies_.count(name); });
  const auto place = place_in(term);
  if (body != names.end())
    pointing.on_body = *body;
  else if (!place)
    return;
  pointing.samples.push_back({t, {place.value_or(Point{})}});
  if (last_avatar_) {
    auto& until = pointings_[*last_avatar_].until;
    until = std::min(until, t);
  }
  last_avatar_ = pointings_.size();
  pointings_.push_back(std::move(pointing));
}

std::vector<RunPointing> PointingReader::finish() {
  for (auto& pointing : pointings_) pointing.until = std::max(pointing.until, pointing.from + shortest_pointing);
  std::stable_sort(pointings_.begin(), pointings_.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
  return std::move(pointings_);
}

std::set<std::string> bodies_of(const Json& header) {
  std::set<std::string> names;
  const auto& bodies = member_of(member_of(header, "scene"), "bodies");
  if (bodies.is_object())
    for (const auto& [name, pose] : bodies.items()) names.insert(name);
  return names;
}

Result<std::vector<RunPointing>> read_pointings(const RunIndex& run) {
  const auto header = run.record(0);
  if (!header) return header.error();
  PointingReader reader(bodies_of(*header));
  for (std::size_t n = 0; n < run.size(); ++n) {
    const auto& kind = run.kind(n);
    if (kind != "input" && kind != "gesture") continue;
    const auto record = run.record(n);
    if (!record) return record.error();
    if (kind == "input")
      reader.input(n, run.entry(n).t, member_of(*record, "event"));
    else
      reader.avatar_gesture(n, run.entry(n).t, text_of(*record, "gesture"));
  }
  return reader.finish();
}

}  // namespace continua
