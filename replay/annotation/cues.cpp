#include "continua/replay/annotation/cues.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

namespace continua {
namespace {

struct Cue {
  std::int64_t begin_ms = 0, end_ms = 0;
  std::string speaker, text;
};

std::vector<Cue> cues_of(const Annotations& annotations) {
  std::vector<Cue> cues;
  for (const auto& tier : annotations.tiers) {
    const auto kind = tier.participant.empty() ? "" : tier.name.substr(tier.participant.size() + 1);
    if (kind != "speech" && kind != "gesture") continue;
    for (const auto& [n, begin, end, value, event] : tier.annotations)
      if (!value.empty()) cues.push_back({begin, end, tier.participant, kind == "speech" ? value : "[" + value + "]"});
  }
  std::stable_sort(cues.begin(), cues.end(), [](const Cue& a, const Cue& b) {
    return std::tie(a.begin_ms, a.end_ms) < std::tie(b.begin_ms, b.end_ms);
  });
  return cues;
}

std::string clock(std::int64_t ms, char mark) {
  return fmt::format("{:02}:{:02}:{:02}{}{:03}", ms / 3'600'000, ms / 60'000 % 60, ms / 1000 % 60, mark, ms % 1000);
}

std::string escaped(const std::string& text) {
  std::string escaped;
  for (const char c : text)
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '>')
      escaped += "&gt;";
    else
      escaped += c;
  return escaped;
}

}  // namespace

std::string vtt_of(const Annotations& annotations) {
  std::string out = "WEBVTT\n";
  for (const auto& [begin, end, speaker, text] : cues_of(annotations))
    out += fmt::format("\n{} --> {}\n<v {}>{}\n", clock(begin, '.'), clock(end, '.'), speaker, escaped(text));
  return out;
}

std::string srt_of(const Annotations& annotations) {
  std::string out;
  int number = 0;
  for (const auto& [begin, end, speaker, text] : cues_of(annotations))
    out += fmt::format("{}{}\n{} --> {}\n{}: {}\n", number > 0 ? "\n" : "", number + 1, clock(begin, ','),
                       clock(end, ','), speaker, text),
        ++number;
  return out;
}

}  // namespace continua
