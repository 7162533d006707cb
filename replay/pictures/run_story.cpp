#include "replay/pictures/run_story.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "replay/run_brief.h"

namespace continua {
namespace {

constexpr SimTime burst_gap{500'000};          // samples farther apart are two pointings
constexpr SimTime shortest_pointing{700'000};  // of one sample, or of a gesture that ends at once
constexpr SimTime avatar_pointing{2'000'000};  // a gesture of the avatar has no end in the log

const Json& member(const Json& object, const char* key) {
  static const Json nothing;
  const auto found = object.is_object() ? object.find(key) : object.end();
  return !object.is_object() || found == object.end() ? nothing : *found;
}

std::optional<Vec3> vec_of(const Json& list) {
  if (!list.is_array() || list.size() < 2 || list.size() > 3) return std::nullopt;
  Vec3 v = Vec3::Zero();
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!list[i].is_number()) return std::nullopt;
    v[static_cast<Eigen::Index>(i)] = list[i].get<double>();
  }
  return v;
}

/// Where the event points, on the table if by a ray; nothing if it points nowhere.
std::optional<StoryPointing::Sample> sample_of(const Json& event, SimTime t) {
  if (const auto target = vec_of(member(event, "target"))) return StoryPointing::Sample{t, *target};
  const auto& ray = member(event, "ray");
  const auto from = vec_of(member(ray, "from")), direction = vec_of(member(ray, "direction"));
  if (!from || !direction || from->z() * direction->z() >= 0) return std::nullopt;
  return StoryPointing::Sample{t, Vec3(*from - *direction * (from->z() / direction->z())), from};
}

/// The last place that a term of the log names: "point(rHand, <0.1, 0, 0>)".
std::optional<Vec3> place_in(const std::string& term) {
  const auto open = term.rfind('<'), close = term.find('>', open);
  if (open == std::string::npos || close == std::string::npos) return std::nullopt;
  return vec_of(Json::parse("[" + term.substr(open + 1, close - open - 1) + "]", nullptr, false));
}

/// The term without the numbers of its places, which are drawn.
std::string without_places(const std::string& term) {
  std::string text;
  for (std::size_t from = 0; from < term.size();) {
    const auto open = std::min(term.find('<', from), term.size()), close = term.find('>', open);
    text += term.substr(from, open - from);
    if (open < term.size()) text += "…";
    from = close == std::string::npos ? term.size() : close + 1;
  }
  return text;
}

/// The names that a term is made of.
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

class StoryReader {
 public:
  explicit StoryReader(const RunIndex& run) : run_(run) {
    const auto header = run.record(0);
    if (!header) return;
    for (const auto& [name, pose] : member(member(*header, "scene"), "bodies").items()) bodies_.insert(name);
  }

  Outcome read() {
    for (std::size_t n = 0; n < run_.size(); ++n) {
      const auto& kind = run_.kind(n);
      if (kind != "input" && kind != "utterance" && kind != "gesture" && kind != "act" && kind != "transition")
        continue;
      const auto record = run_.record(n);
      if (!record) return record.error();
      const auto t = run_.entry(n).t;
      if (kind == "input")
        input(n, t, member(*record, "event"));
      else if (kind == "transition")
        story_.states.push_back({t, text_of(*record, "to")});
      else if (kind == "act")
        act(t, *record);
      else if (kind == "utterance")
        story_.lines.push_back({Speaker::avatar, text_of(*record, "text"), t, t});
      else
        avatar_gesture(t, text_of(*record, "gesture"));
      for (const auto& because : member(*record, "because"))
        if (because.is_number_unsigned()) effective_.insert(because.get<std::size_t>());
      if (const auto cause = run_.cause(n); cause && kind == "transition") effective_.insert(*cause);
    }
    return std::nullopt;
  }

  RunStory finish() {
    for (const auto& [line, n] : line_inputs_) story_.lines[line].effective = effective_.count(n) > 0;
    for (std::size_t i = 0; i < story_.pointings.size(); ++i) {
      const auto& inputs = pointing_inputs_[i];
      auto& pointing = story_.pointings[i];
      if (pointing.speaker == Speaker::human)
        pointing.effective = std::any_of(inputs.begin(), inputs.end(), [&](auto n) { return effective_.count(n) > 0; });
      pointing.until = std::max(pointing.until, pointing.from + shortest_pointing);
    }
    story_.end = run_.entry(run_.size() - 1).t;
    const auto by_time = [](auto& list, auto time) {
      std::stable_sort(list.begin(), list.end(), [&](const auto& a, const auto& b) { return time(a) < time(b); });
    };
    by_time(story_.lines, [](const StoryLine& line) { return line.from; });
    by_time(story_.pointings, [](const StoryPointing& pointing) { return pointing.from; });
    return std::move(story_);
  }

 private:
  void input(std::size_t n, SimTime t, const Json& event) {
    const auto kind = text_of(event, "kind");
    const auto until = member(event, "until").is_number() ? SimTime::from_seconds(event["until"].get<double>()) : t;
    if (kind == "speech") {
      auto text = text_of(event, "text");
      const auto& others = member(event, "alternatives");
      if (text.empty() && others.is_array() && !others.empty()) text = text_of(others[0], "text");
      line(n, {Speaker::human, text, t, until});
    } else if (kind == "gesture") {
      human_gesture(n, t, until, event);
    } else if (kind == "pointing") {
      point(n, t, t, event);
    }
  }

  void human_gesture(std::size_t n, SimTime t, SimTime until, const Json& event) {
    const auto hand = text_of(event, "hand") + "/" + text_of(event, "name");
    const bool ends = text_of(event, "phase") == "stop";
    if (const auto held = held_.find(hand); held != held_.end()) {
      story_.pointings[held->second].until = std::max(story_.pointings[held->second].until, t);
      held_.erase(held);
    }
    if (ends) return;
    auto name = text_of(event, "name");
    if (name.empty() && member(event, "alternatives").is_array() && !event["alternatives"].empty())
      name = text_of(event["alternatives"][0], "name");
    const auto direction = text_of(event, "direction");
    std::replace(name.begin(), name.end(), '_', ' ');
    line(n, {Speaker::human, fmt::format("[{}{}{}]", name, direction.empty() ? "" : " ", direction), t, until, true});
    const auto pointing = point(n, t, until, event);
    if (pointing && text_of(event, "phase") == "start") held_[hand] = *pointing;
  }

  /// The place in pointings of what the event begins or goes on with, if it points anywhere.
  std::optional<std::size_t> point(std::size_t n, SimTime t, SimTime until, const Json& event) {
    const auto sample = sample_of(event, t);
    if (!sample) return std::nullopt;
    const auto hand = text_of(event, "hand");
    const auto burst = bursts_.find(hand);
    // Also a gesture goes on with the samples around it, so that one hand never shows two places.
    if (burst != bursts_.end() && t - story_.pointings[burst->second].until <= burst_gap) {
      auto& pointing = story_.pointings[burst->second];
      pointing.samples.push_back(*sample);
      pointing.until = std::max(pointing.until, until);
      pointing_inputs_[burst->second].push_back(n);
      return burst->second;
    }
    story_.pointings.push_back({Speaker::human, t, until, {*sample}, hand});
    pointing_inputs_.push_back({n});
    return bursts_[hand] = story_.pointings.size() - 1;
  }

  void avatar_gesture(SimTime t, const std::string& term) {
    story_.lines.push_back({Speaker::avatar, "[" + without_places(term) + "]", t, t, true});
    StoryPointing pointing{Speaker::avatar, t, t + avatar_pointing};
    const auto names = names_in(term);
    const auto body = std::find_if(names.begin(), names.end(), [&](const auto& name) { return bodies_.count(name); });
    const auto place = place_in(term);
    if (body != names.end())
      pointing.on_body = *body;
    else if (!place)
      return;
    pointing.samples.push_back({t, place.value_or(Vec3::Zero())});
    for (auto& other : story_.pointings) {
      if (other.speaker == Speaker::avatar && other.until > t) other.until = t;
    }
    story_.pointings.push_back(pointing);
    pointing_inputs_.emplace_back();
  }

  void act(SimTime t, const Json& record) {
    const auto status = text_of(record, "status"), program = text_of(record, "program");
    const bool step = record.contains("step");
    const bool begins = status == "started", ends = !begins && status != "asked";
    const auto& result = member(record, "result");
    if (ends) story_.deeds.push_back({t, program, status, text_of(result, "reason"), step});
    if (step) return;
    if (begins) story_.doing.push_back({t, program});
    if (ends && !story_.doing.empty() && story_.doing.back().text == program) story_.doing.push_back({t, ""});
  }

  void line(std::size_t n, StoryLine said) {
    line_inputs_.emplace_back(story_.lines.size(), n);
    story_.lines.push_back(std::move(said));
  }

  const RunIndex& run_;
  RunStory story_;
  std::set<std::string> bodies_;
  std::set<std::size_t> effective_;                               // inputs that something came of
  std::vector<std::pair<std::size_t, std::size_t>> line_inputs_;  // place in lines, input
  std::vector<std::vector<std::size_t>> pointing_inputs_;         // of each pointing
  std::map<std::string, std::size_t> bursts_, held_;              // hand, hand/gesture → place in pointings
};

}  // namespace

Result<RunStory> read_story(const RunIndex& run) {
  StoryReader reader(run);
  if (auto problem = reader.read()) return *problem;
  return reader.finish();
}

std::string state_at(const std::vector<StoryState>& states, SimTime t) {
  const auto after =
      std::upper_bound(states.begin(), states.end(), t, [](SimTime time, const auto& state) { return time < state.t; });
  return after == states.begin() ? "" : std::prev(after)->text;
}

}  // namespace continua
