#include "continua/replay/pictures/key_moments.h"

#include <algorithm>

#include <fmt/format.h>

namespace continua {
namespace {

constexpr SimTime together{600'000};  // happenings no farther apart are one moment

constexpr auto who_human = "Human", who_avatar = "Avatar", who_acts = "Act";

enum Weight { of_step = 1, of_gesture = 2, of_speech = 4, of_act = 6, of_failure = 8 };

std::vector<KeyMoment> all_moments(const RunStory& story) {
  std::vector<KeyMoment> all;
  for (const auto& line : story.lines) {
    if (!line.effective || line.text.empty() || (line.gesture && line.speaker == Speaker::avatar)) continue;
    const char* who = line.speaker == Speaker::human ? who_human : who_avatar;
    all.push_back(
        {std::max(line.from, line.until), {{who, line.text, line.from}}, line.gesture ? of_gesture : of_speech});
  }
  for (const auto& pointing : story.pointings) {
    const bool told = std::any_of(story.lines.begin(), story.lines.end(), [&](const StoryLine& line) {
      return line.gesture && line.speaker == pointing.speaker && line.from >= pointing.from &&
             line.from <= pointing.until;
    });
    if (pointing.effective && !told)
      all.push_back({pointing.samples.back().t, {{who_human, "[pointing]", pointing.from}}, of_gesture});
  }
  for (const auto& deed : story.deeds) {
    const bool done = deed.status == "done", given_up = deed.status == "stopped";
    if (deed.step && done && !deed.reason.empty()) continue;  // there was nothing to do
    const auto text =
        fmt::format("{}: {}{}{}", deed.program, deed.status, deed.reason.empty() ? "" : ", ", deed.reason);
    all.push_back({deed.t,
                   {{who_acts, text, deed.t, deed.step}},
                   deed.step          ? of_step
                   : done || given_up ? of_act
                                      : of_failure});
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.t < b.t; });
  return all;
}

// Words and gestures of one speaker at one time are told in one line.
void add(Happening one, std::vector<Happening>& happenings) {
  const auto same =
      std::find_if(happenings.begin(), happenings.end(), [&](const auto& other) { return other.who == one.who; });
  if (one.who == who_acts || same == happenings.end())
    happenings.push_back(std::move(one));
  else
    same->text += " " + one.text;
}

void merge(std::vector<KeyMoment>& moments) {
  std::vector<KeyMoment> merged;
  SimTime first{};
  for (auto& moment : moments) {
    if (merged.empty() || moment.t - first > together) {
      first = moment.t;
      merged.push_back(std::move(moment));
      continue;
    }
    auto& into = merged.back();
    into.t = moment.t;
    into.weight = std::max(into.weight, moment.weight);
    into.happenings.push_back(std::move(moment.happenings.front()));
  }
  moments = std::move(merged);
  for (auto& moment : moments) {
    std::stable_sort(moment.happenings.begin(), moment.happenings.end(), [](const auto& a, const auto& b) {
      return std::pair(a.began, a.who != who_human) < std::pair(b.began, b.who != who_human);
    });
    std::vector<Happening> all;
    for (auto& one : moment.happenings) add(std::move(one), all);
    if (!std::all_of(all.begin(), all.end(), [](const auto& one) { return one.step; }))
      std::erase_if(all, [](const auto& one) { return one.step; });
    moment.happenings = std::move(all);
  }
}

}  // namespace

std::vector<KeyMoment> key_moments(const RunStory& story, std::size_t most) {
  auto moments = all_moments(story);
  merge(moments);
  while (moments.size() > std::max<std::size_t>(most, 1)) {
    const auto gap = [&](std::size_t i) {
      const auto before = i == 0 ? moments[i].t : moments[i].t - moments[i - 1].t;
      const auto after = i + 1 == moments.size() ? story.end - moments[i].t : moments[i + 1].t - moments[i].t;
      return std::min(before, after);
    };
    std::size_t least = 0;
    for (std::size_t i = 1; i < moments.size(); ++i)
      if (std::pair(moments[i].weight, gap(i)) < std::pair(moments[least].weight, gap(least))) least = i;
    moments.erase(moments.begin() + static_cast<std::ptrdiff_t>(least));
  }
  if (moments.empty()) moments.push_back({story.end, {}, 0});
  return moments;
}

}  // namespace continua
