#include "continua/replay/scene/run_pointing.h"

#include <algorithm>

#include "continua/replay/log/kinds.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/run_brief.h"
#include "continua/term/written_term.h"

namespace continua {
namespace {

constexpr SimTime burst_gap{500'000};          // samples farther apart are two pointings
constexpr SimTime shortest_pointing{700'000};  // of one sample, or of a gesture that ends at once
constexpr SimTime avatar_pointing{2'000'000};  // a gesture of the avatar has no end in the log

// The first body that the term names, from left to right; empty if it names none.
std::string first_body(const WrittenTerm& term, const std::set<std::string>& bodies) {
  if (bodies.count(term.name)) return term.name;
  for (const auto& part : term.parts)
    if (auto body = first_body(part, bodies); !body.empty()) return body;
  return "";
}

// A string as written, without its quotes; nothing for any other value or for a string with escapes.
std::optional<std::string> plain_text(std::string_view value) {
  if (value.size() < 2 || value.front() != '"' || value.find('\\') != std::string_view::npos) return std::nullopt;
  return std::string(value.substr(1, value.size() - 2));
}

// A pointing sample, read without building a tree: samples come by the hundred thousand. Nothing where the event is of
// another kind, or has more than a hand and a target.
struct Sample {
  std::string hand;
  PointedAt at;
};
std::optional<Sample> sample_in(std::string_view event) {
  Sample sample;
  bool pointing = false, targeted = false, more = false;
  const auto member = [&](std::string_view key, std::string_view value) {
    if (key == "kind") {
      pointing = value == "\"pointing\"";
    } else if (key == "hand") {
      const auto hand = plain_text(value);
      more = more || !hand;
      sample.hand = hand.value_or("");
    } else if (key == "target") {
      std::size_t count = 0;
      const auto element = [&](std::string_view number) {
        const auto read = number_in<double>(number);
        more = more || !read || count >= sample.at.target.size();
        if (!more) sample.at.target[count++] = *read;
      };
      targeted = scan_elements(value, element) && count >= 2;
    } else if (key == "ray" || key.find('\\') != std::string_view::npos) {
      more = true;
    }
  };
  if (!scan_members(event, member) || !pointing || !targeted || more) return std::nullopt;
  return sample;
}

}  // namespace

void PointingReader::input(std::size_t n, SimTime t, const Json& event) {
  const auto kind = text_of(event, "kind"), hand = text_of(event, "hand");
  const auto at = pointed_at(event);
  if (kind == "pointing" && at) point(n, t, t, hand, *at);
  if (kind != "gesture") return;
  const auto phase = text_of(event, "phase"), gesture = hand + "/" + text_of(event, "name");
  if (const auto held = held_.find(gesture); held != held_.end()) {
    auto& until = pointings_[held->second].until;
    until = std::max(until, t);
    held_.erase(held);
  }
  if (phase == "stop" || !at) return;
  const auto pointing = point(n, t, time_in(member_of(event, "until"), t), hand, *at);
  if (phase == "start") held_[gesture] = pointing;
}

void PointingReader::input(std::size_t n, SimTime t, std::string_view event) {
  if (const auto sample = sample_in(event))
    point(n, t, t, sample->hand, sample->at);
  else
    input(n, t, Json::parse(event, nullptr, false));
}

/// The place in pointings_ of the pointing that the event begins or goes on with, if it points anywhere.
std::size_t PointingReader::point(std::size_t n, SimTime t, SimTime until, const std::string& hand,
                                  const PointedAt& at) {
  const auto burst = bursts_.find(hand);
  // Also a gesture goes on with the samples around it, so that one hand never shows two places.
  if (burst != bursts_.end() && t - pointings_[burst->second].until <= burst_gap) {
    auto& pointing = pointings_[burst->second];
    pointing.samples.push_back({t, at});
    pointing.until = std::max(pointing.until, until);
    pointing.records.push_back(n);
    return burst->second;
  }
  pointings_.push_back({false, t, until, {{t, at}}, hand, "", {n}});
  return bursts_[hand] = pointings_.size() - 1;
}

void PointingReader::avatar_gesture(std::size_t n, SimTime t, const std::string& term) {
  RunPointing pointing{true, t, t + avatar_pointing, {}, "", "", {n}};
  const auto read = read_written_term(term);
  const auto written = read ? *read : WrittenTerm();
  const auto* place = last_place(written);
  pointing.on_body = first_body(written, bodies_);
  if (pointing.on_body.empty() && !place) return;
  pointing.samples.push_back({t, {place ? place->min : Point{}}});
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
  const auto& header = run.header();
  if (!header) return header.error();
  PointingReader reader(bodies_of(*header));
  for (std::size_t n = 0; n < run.size(); ++n) {
    const auto& kind = run.kind(n);
    if (!log::is<log::Input>(kind) && !log::is<log::AvatarGesture>(kind)) continue;
    const auto line = run.line(n);
    if (!line) return line.error();
    scan_members(*line, [&](std::string_view key, std::string_view value) {
      if (log::is<log::Input>(kind) && key == "event") reader.input(n, run.entry(n).t, value);
      if (log::is<log::AvatarGesture>(kind) && key == "gesture")
        reader.avatar_gesture(n, run.entry(n).t, plain_text(value).value_or(""));
    });
  }
  return reader.finish();
}

}  // namespace continua
