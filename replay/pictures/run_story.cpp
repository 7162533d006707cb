#include "continua/replay/pictures/run_story.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "continua/replay/log/kinds.h"
#include "continua/replay/log/run_brief.h"
#include "continua/replay/log/run_sources.h"
#include "continua/replay/log/run_words.h"
#include "continua/replay/scene/run_pointing.h"

namespace continua {
namespace {

Vec3 vec_of(const Point& point) { return {point[0], point[1], point[2]}; }

StoryPointing story_of(const RunPointing& read) {
  StoryPointing pointing{read.avatar ? Speaker::avatar : Speaker::human, read.from, read.until};
  pointing.hand = read.hand;
  pointing.on_body = read.on_body;
  for (const auto& [t, at] : read.samples)
    pointing.samples.push_back({t, vec_of(at.target), at.origin ? std::optional(vec_of(*at.origin)) : std::nullopt});
  return pointing;
}

class StoryReader {
 public:
  StoryReader(const RunIndex& run, std::set<std::string> bodies)
      : run_(run), words_(run), sources_(run), pointings_(std::move(bodies)) {}

  Outcome read() {
    for (std::size_t n = 0; n < run_.size(); ++n) {
      const auto& kind = run_.kind(n);
      if (!log::is<log::Input>(kind) && !log::is<log::Utterance>(kind) && !log::is<log::AvatarGesture>(kind) &&
          !log::is<log::Act>(kind) && !log::is<log::Transition>(kind))
        continue;
      const auto record = run_.record(n);
      if (!record) return record.error();
      const auto t = run_.entry(n).t;
      if (log::is<log::Input>(kind))
        input(n, t, member_of(*record, "event"));
      else if (log::is<log::Transition>(kind))
        story_.states.push_back({t, text_of(*record, "to")});
      else if (log::is<log::Act>(kind))
        act(t, *record);
      else if (log::is<log::Utterance>(kind))
        story_.lines.push_back({Speaker::avatar, text_of(*record, "text"), t, t});
      else
        avatar_gesture(n, t, text_of(*record, "gesture"));
      if (auto problem = sources_.add(n, *record)) return problem;
      if (const auto cause = run_.cause(n); cause && log::is<log::Transition>(kind)) effective_.insert(*cause);
    }
    return std::nullopt;
  }

  RunStory finish() {
    effective_.insert(sources_.inputs().begin(), sources_.inputs().end());
    for (const auto& [line, n] : line_inputs_) story_.lines[line].effective = effective_.count(n) > 0;
    for (const auto& read : pointings_.finish()) {
      story_.pointings.push_back(story_of(read));
      const auto came_of = [&](std::size_t n) { return effective_.count(n) > 0; };
      story_.pointings.back().effective = read.avatar || std::any_of(read.records.begin(), read.records.end(), came_of);
    }
    story_.end = run_.entry(run_.size() - 1).t;
    std::stable_sort(story_.lines.begin(), story_.lines.end(),
                     [](const auto& a, const auto& b) { return a.from < b.from; });
    return std::move(story_);
  }

 private:
  void input(std::size_t n, SimTime t, const Json& event) {
    pointings_.input(n, t, event);
    const auto kind = text_of(event, "kind");
    const auto until = time_in(member_of(event, "until"), t);
    const auto& others = member_of(event, "alternatives");
    const auto first = others.is_array() && !others.empty() ? others[0] : Json();
    if (kind == "speech") {
      auto text = text_of(event, "text");
      if (text.empty()) text = text_of(first, "text");
      line(n, {Speaker::human, text, t, until});
    } else if (kind == "gesture" && text_of(event, "phase") != "stop") {
      auto name = text_of(event, "name");
      if (name.empty()) name = text_of(first, "name");
      line(n, {Speaker::human, "[" + words_.gesture(name, text_of(event, "direction")) + "]", t, until, true});
    }
  }

  void avatar_gesture(std::size_t n, SimTime t, const std::string& term) {
    story_.lines.push_back({Speaker::avatar, "[" + words_.term(term) + "]", t, t, true});
    pointings_.avatar_gesture(n, t, term);
  }

  void act(SimTime t, const Json& record) {
    const auto status = text_of(record, "status"), program = words_.term(text_of(record, "program"));
    const bool step = record.contains("step");
    const bool begins = status == "started", ends = !begins && status != "asked";
    const auto& result = member_of(record, "result");
    if (ends) story_.deeds.push_back({t, program, status, words_.named(text_of(result, "reason")), step});
    if (step) return;
    if (begins) story_.doing.push_back({t, program});
    if (ends && !story_.doing.empty() && story_.doing.back().text == program) story_.doing.push_back({t, ""});
  }

  void line(std::size_t n, StoryLine said) {
    line_inputs_.emplace_back(story_.lines.size(), n);
    story_.lines.push_back(std::move(said));
  }

  const RunIndex& run_;
  const RunWords words_;
  RunSources sources_;
  RunStory story_;
  PointingReader pointings_;
  std::set<std::size_t> effective_;                               // inputs that something came of
  std::vector<std::pair<std::size_t, std::size_t>> line_inputs_;  // place in lines, input
};

}  // namespace

Result<RunStory> read_story(const RunIndex& run) {
  const auto& header = run.header();
  if (!header) return header.error();
  StoryReader reader(run, bodies_of(*header));
  if (auto problem = reader.read()) return *problem;
  return reader.finish();
}

std::string state_at(const std::vector<StoryState>& states, SimTime t) {
  const auto after =
      std::upper_bound(states.begin(), states.end(), t, [](SimTime time, const auto& state) { return time < state.t; });
  return after == states.begin() ? "" : std::prev(after)->text;
}

}  // namespace continua
