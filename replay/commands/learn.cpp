#include "continua/replay/commands/learn.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <optional>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "continua/core/located_json.h"
#include "continua/core/replaced_file.h"
#include "continua/core/several_at_once.h"
#include "continua/machine_file/machine_weights.h"
#include "continua/replay/learn/learning_run.h"
#include "continua/replay/session/shelf.h"

namespace continua {
namespace {

// The results for several traces, in their order, some at a time. The error is that of the first trace with one.
template <class Value>
Result<std::vector<Value>> for_each_trace(const std::vector<std::string>& traces, int jobs,
                                          const std::function<Result<Value>(const std::string&)>& make) {
  std::vector<std::optional<Result<Value>>> made(traces.size());
  several_at_once(traces.size(), jobs, [&](std::size_t i) { made[i] = make(traces[i]); });
  std::vector<Value> values;
  for (auto& one : made) {
    if (!*one) return one->error();
    values.push_back(std::move(**one));
  }
  return values;
}

// The inputs and answers of several traces.
LearningRun joined(std::vector<LearningRun> runs) {
  LearningRun all;
  for (auto& run : runs) {
    std::move(run.inputs.begin(), run.inputs.end(), std::back_inserter(all.inputs));
    all.answers.merge(run.answers);
  }
  return all;
}

struct Fit {
  double log_likelihood = 0;
  Score score;
};

double share(int part, int whole) { return whole ? static_cast<double>(part) / whole : 1; }

Json told(const Fit& fit) {
  const auto rounded = [](double value) { return std::round(value * 1e4) / 1e4; };
  return {{"log_likelihood", rounded(fit.log_likelihood)},
          {"answers", fit.score.speaking},
          {"answers_right", fit.score.lax},
          {"inputs_right", fit.score.right}};
}

class Learning {
 public:
  Learning(const LearnOptions& options, Machine machine)
      : options_(options), machine_(std::move(machine)), replay_(options.replay) {
    replay_.machine = options.machine;
    replay_.shelf = std::make_shared<Shelf>();
    for (std::size_t i = 0; i < options.traces.size(); ++i) {
      const auto held = [&](std::size_t count) {
        return std::floor(static_cast<double>(count) * options.held_out + 1e-9);
      };
      (held(i + 1) > held(i) ? held_out_ : learned_from_).push_back(options.traces[i]);
    }
  }

  Outcome run() {
    auto learned_from = runs_of(learned_from_), held_out = runs_of(held_out_);
    if (!learned_from) return learned_from.error();
    if (!held_out) return held_out.error();
    const auto& inputs = learned_from->inputs;
    const auto otherwise = otherwise_of(inputs, learned_from->answers.size());
    const auto before = weights_of(machine_);
    const auto after = estimate(inputs, before, otherwise);
    auto document = weights_document(machine_, after);
    document["learned"] = {{"traces", learned_from_.size()}, {"inputs", inputs.size()}};
    say_learned(inputs);
    if (!held_out_.empty())
      if (auto problem = compare(held_out->inputs, before, after, otherwise, document)) return problem;
    const auto text = document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    if (const auto problem = replace_file(options_.output, text)) return problem;
    fmt::print("{} weights and {} rows of evidence -> {}\n", document["transitions"].size(),
               document["evidence"].size(), options_.output);
    return std::nullopt;
  }

 private:
  Result<LearningRun> runs_of(const std::vector<std::string>& traces) const {
    auto runs = for_each_trace<LearningRun>(traces, options_.jobs,
                                            [&](const std::string& trace) { return run_for_learning(trace, replay_); });
    if (!runs) return runs.error();
    return joined(std::move(*runs));
  }

  void say_learned(const std::vector<AnsweredInput>& inputs) const {
    const auto choices = std::count_if(inputs.begin(), inputs.end(), [](const AnsweredInput& input) {
      return input.sure.size() > 1 || input.unsure.size() > 1;
    });
    const auto evidence =
        std::count_if(inputs.begin(), inputs.end(), [](const AnsweredInput& input) { return !input.evidence.empty(); });
    fmt::print("learned from {} of {} traces: {} inputs, {} of them with rival transitions, {} as evidence\n",
               learned_from_.size(), options_.traces.size(), inputs.size(), choices, evidence);
  }

  // The traces held out under the weights of before and those learned, on standard output and in the document.
  Outcome compare(const std::vector<AnsweredInput>& inputs, const MachineWeights& before, const MachineWeights& after,
                  const Otherwise& otherwise, Json& document) const {
    Fit was{log_likelihood(inputs, before, otherwise), {}}, is{log_likelihood(inputs, after, otherwise), {}};
    auto options = replay_;
    auto scored = scores_of(options);
    if (!scored) return scored.error();
    was.score = *scored;
    options.own_weights = std::make_shared<const MachineWeights>(after);
    scored = scores_of(options);
    if (!scored) return scored.error();
    is.score = *scored;
    const auto count = static_cast<double>(inputs.size());
    fmt::print("{} held out: {} inputs, {} answers  before     after\n", held_out_.size(), inputs.size(),
               was.score.speaking);
    fmt::print("log-likelihood                  {:>10.2f}{:>10.2f}\n", was.log_likelihood, is.log_likelihood);
    fmt::print("log-likelihood of an input      {:>10.4f}{:>10.4f}\n", was.log_likelihood / count,
               is.log_likelihood / count);
    fmt::print("answers right                   {:>8.2f} %{:>8.2f} %\n", 100 * share(was.score.lax, was.score.speaking),
               100 * share(is.score.lax, is.score.speaking));
    fmt::print("inputs right                    {:>8.2f} %{:>8.2f} %\n", 100 * share(was.score.right, was.score.inputs),
               100 * share(is.score.right, is.score.inputs));
    document["learned"]["held_out"] = {
        {"traces", held_out_.size()}, {"inputs", inputs.size()}, {"before", told(was)}, {"after", told(is)}};
    return std::nullopt;
  }

  Result<Score> scores_of(const ReplayOptions& options) const {
    const auto scores = for_each_trace<Score>(held_out_, options_.jobs,
                                              [&](const std::string& trace) { return score_of(trace, options); });
    if (!scores) return scores.error();
    Score all;
    for (const auto& one : *scores) all.add(one);
    return all;
  }

  const LearnOptions& options_;
  Machine machine_;
  ReplayOptions replay_;
  std::vector<std::string> learned_from_, held_out_;
};

}  // namespace

int run_learn(const LearnOptions& options) {
  auto inputs = options.traces;
  inputs.insert(inputs.end(), {options.machine, options.replay.scene});
  if (const auto problem = not_an_input({options.output}, inputs)) return report(*problem), exit_impossible;
  auto replay = options.replay;
  replay.machine = options.machine;
  auto machine = machine_of(options.traces.front(), replay);
  if (!machine) return report(machine.error()), exit_impossible;
  if (const auto problem = Learning(options, std::move(*machine)).run()) return report(*problem), exit_impossible;
  return exit_done;
}

void describe_learn(CLI::App& command, LearnOptions& options) {
  command.add_option("MACHINE", options.machine, "a name or a machine file")->required();
  command.add_option("TRACE", options.traces, "traces (.jsonl, .jsonl.gz) with `observed` events")->required();
  command.add_option("-o,--output", options.output, "the file of weights, for --weights of other commands")->required();
  command
      .add_option("--held-out", options.held_out,
                  "the share of the traces, evenly among them, that is not learned from but only compared; otherwise "
                  "0.5")
      ->check(CLI::Range(0.0, 0.9));
  command.add_option("--weights", options.replay.weights, "the weights to begin with; otherwise the machine's own");
  command.add_option("--scene", options.replay.scene, "a name or an MJCF file; otherwise the trace's");
  command.add_option("--knowledge", options.replay.knowledge,
                     "folder of machines, lexicon, voxemes; otherwise the program's");
  command.add_option("-j,--jobs", options.jobs, "how many traces at a time")->check(CLI::Range(1, 256));
  command.footer(
      "Traces are replayed in the kinematic world as their teacher answered (continua score --variant teacher).\n"
      "replay/learn/LEARN.md says how weights and levels are estimated.\n"
      "Exit status: 0 done, 2 it could not be done.\n"
      "Examples: continua learn diana2018 traces/pilot/*.jsonl -o learned.json -j 2\n"
      "          continua score traces/pilot/*.jsonl --variant teacher --weights learned.json");
}

}  // namespace continua
