// A trace with the observed answers of another avatar, replayed for learning: what was tried of each input, and how
// well the machine answers as it is.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/learn/estimate.h"
#include "continua/replay/score/score.h"
#include "continua/replay/session/session.h"

namespace continua {

struct LearningRun {
  std::vector<AnsweredInput> inputs;  ///< those that were not mere samples of pointing without an answer
  std::set<std::string> answers;      ///< the different observed answers, as templates
};

/// Replays the trace as its teacher answered (Variant::teacher). Where ways of the machine agree with an observed
/// answer, the run goes on with the likeliest of them. Errors: the trace, its scene or the machine cannot be used, or
/// nothing was observed.
Result<LearningRun> run_for_learning(const std::string& trace, const ReplayOptions& options);

/// How the machine answers the traces' inputs, under these options.
Result<Score> score_of(const std::string& trace, const ReplayOptions& options);

/// The machine that the options name.
Result<Machine> machine_of(const std::string& trace, const ReplayOptions& options);

}  // namespace continua
