#include "continua/replay/score/score.h"

#include <algorithm>

namespace continua {

void Score::add(const Episode& episode) {
  const bool observed = !episode.observed.empty(), produced = !episode.produced.empty();
  const auto reaches = [&](AgreementLevel level) { return episode.level >= level; };
  if (episode.sample && !observed) {
    ++samples;
    silent_samples += !produced;
    return;
  }
  answered += produced;
  if (observed) {
    ++speaking;
    exact += reaches(AgreementLevel::exact);
    lax += reaches(AgreementLevel::lax);
    same_template += reaches(AgreementLevel::same_template);
  }
  if (episode.sample) return;
  ++inputs;
  spurious += produced && !observed;
  right += reaches(AgreementLevel::lax);
}

void Score::add(const Score& other) {
  inputs += other.inputs;
  speaking += other.speaking;
  exact += other.exact;
  lax += other.lax;
  same_template += other.same_template;
  answered += other.answered;
  spurious += other.spurious;
  right += other.right;
  samples += other.samples;
  silent_samples += other.silent_samples;
}

double Score::f1() const {
  // With TP = lax, FN = speaking - lax and FP = answered - lax, 2TP + FN + FP is the number of observed answers and
  // given ones.
  const int both = speaking + answered;
  return both == 0 ? 1 : 2.0 * lax / both;
}

bool is_miss(const Episode& episode) { return episode.level < AgreementLevel::lax; }

std::string kind_of(const Episode& episode, const Blanks& blanks) {
  const auto first = [&](const char* channel) {
    return std::find_if(episode.observed.begin(), episode.observed.end(),
                        [&](const AvatarMove& move) { return move.channel == channel; });
  };
  for (const auto* channel : {"action", "speech"})
    if (const auto move = first(channel); move != episode.observed.end()) return template_of(*move, blanks);
  if (episode.observed.empty()) return {};
  const auto& gesture = episode.observed.front().content;
  return gesture.substr(0, gesture.find('('));
}

void TraceScore::add(Episode episode, const Blanks& blanks) {
  score.add(episode);
  if (!episode.observed.empty()) kinds[kind_of(episode, blanks)].add(episode);
  if (is_miss(episode)) misses.push_back(std::move(episode));
}

}  // namespace continua
