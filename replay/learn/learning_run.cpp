#include "continua/replay/learn/learning_run.h"

#include <algorithm>
#include <map>
#include <memory>
#include <ostream>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "continua/knowledge_files/engine_parts.h"
#include "continua/replay/learn/rehearsal.h"

namespace continua {
namespace {

ReplayOptions taught(ReplayOptions options) {
  options.physics = false;
  options.variant = Variant::teacher;
  return options;
}

Result<std::vector<Episode>> episodes_of(const std::string& trace, const ReplayOptions& options, Blanks& blanks) {
  auto wanted = options;
  wanted.episodes = true;
  auto session = Session::load(trace, wanted);
  if (!session) return session.error();
  blanks = session->blanks();
  std::ostream nowhere(nullptr);
  return session->run(nowhere).episodes;
}

double probability_of(const Way& way, const Machine& machine) {
  double probability = 1;
  for (const auto& pick : way.picks) {
    double total = 0;
    for (const auto& [transition, confidence] : pick.rivals)
      total += confidence * machine.transitions[transition].weight;
    const auto& [taken, confidence] = pick.rivals[pick.taken];
    probability *= confidence * machine.transitions[taken].weight / total;
  }
  return probability;
}

// Compares what was tried with the observed answers, as the inputs come.
class Pupil {
 public:
  Pupil(const std::vector<Episode>& episodes, Blanks blanks) : blanks_(std::move(blanks)) {
    for (const auto& episode : episodes)
      if (!episode.sample || !episode.observed.empty()) observed_[episode.line] = episode.observed;
  }

  std::map<int, std::size_t> look(const Pipeline& pipeline, const EngineState& state, const InputEvent& event,
                                  const WorldSnapshot& world, std::size_t line, const EngineParts& parts) {
    const auto observed = observed_.find(line);
    if (observed == observed_.end()) return {};
    if (!rehearsal_) rehearsal_ = std::make_unique<Rehearsal>(parts.machine, parts.language, parts.perspective);
    auto rehearsed = rehearsal_->rehearse(state, event, world);
    run_.answers.insert(fmt::format("{}", fmt::join(template_of(observed->second, blanks_), "; ")));
    AnsweredInput input;
    input.evidence = std::move(rehearsed.evidence);
    for (auto* tried : {&rehearsed.sure, &rehearsed.unsure})
      for (auto& one : *tried) one.way.matches = agreement(observed->second, one.deeds, blanks_) >= AgreementLevel::lax;
    std::map<int, std::size_t> steps;
    double best = 0;
    for (const auto& one : rehearsed.sure) {
      const double probability = probability_of(one.way, pipeline.machine());
      if (!one.way.matches || probability <= best) continue;
      best = probability;
      steps = one.steps;
    }
    for (auto& one : rehearsed.sure) input.sure.push_back(std::move(one.way));
    for (auto& one : rehearsed.unsure) input.unsure.push_back(std::move(one.way));
    run_.inputs.push_back(std::move(input));
    return steps;
  }

  LearningRun take() { return std::move(run_); }

 private:
  Blanks blanks_;
  std::map<std::size_t, std::vector<AvatarMove>> observed_;  // by line of the trace
  std::unique_ptr<Rehearsal> rehearsal_;
  LearningRun run_;
};

}  // namespace

Result<LearningRun> run_for_learning(const std::string& trace, const ReplayOptions& options) {
  auto teacher = taught(options);
  Blanks blanks;
  const auto episodes = episodes_of(trace, teacher, blanks);
  if (!episodes) return episodes.error();
  if (std::all_of(episodes->begin(), episodes->end(), [](const Episode& one) { return one.observed.empty(); }))
    return Error{trace, "nothing was observed; expected `observed` events to learn from"};
  Pupil pupil(*episodes, std::move(blanks));
  const EngineParts* parts = nullptr;
  teacher.before_input = [&](const Pipeline& pipeline, const EngineState& state, const InputEvent& event,
                             const WorldSnapshot& world,
                             std::size_t line) { return pupil.look(pipeline, state, event, world, line, *parts); };
  auto session = Session::load(trace, teacher);
  if (!session) return session.error();
  parts = &session->parts();
  std::ostream nowhere(nullptr);
  session->run(nowhere);
  return pupil.take();
}

Result<Score> score_of(const std::string& trace, const ReplayOptions& options) {
  Blanks blanks;
  const auto episodes = episodes_of(trace, taught(options), blanks);
  if (!episodes) return episodes.error();
  Score score;
  for (const auto& episode : *episodes) score.add(episode);
  return score;
}

Result<Machine> machine_of(const std::string& trace, const ReplayOptions& options) {
  const auto session = Session::load(trace, taught(options));
  if (!session) return session.error();
  return session->machine();
}

}  // namespace continua
