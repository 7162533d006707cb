// A conversation: takes events of the human and the course of time; returns the happenings of engine and world.
//
//   Conversation conversation(parts, body);
//   conversation.begin();
//   for (const auto& happening : conversation.hear(event)) …
//   for (const auto& happening : conversation.advance(t)) …
//
// The division of time into calls makes no difference.
#pragma once

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "continua/body/body.h"
#include "continua/knowledge_files/engine_parts.h"
#include "continua/pipeline/pipeline.h"

namespace continua {

/// The engine's events of one instant, in order. The body has received the commands among them.
struct Thought {
  SimTime t;
  std::vector<EngineEvent> events;
};

/// A thought, or the world's report up to an instant at which an act ended.
using Happening = std::variant<Thought, WorldReport>;

class Conversation {
 public:
  /// `body` must outlive the conversation. `most_branches`: the most configurations under `explore`.
  Conversation(EngineParts parts, Body& body, std::size_t most_branches = default_most_branches);

  /// The first call. `learned`: lessons of earlier conversations.
  std::vector<Happening> begin(Learned learned = {});
  /// An event of the human's at now(), with all immediate consequences.
  std::vector<Happening> hear(const InputEvent& event);
  /// Time goes on to `t`: acts end, and inputs that waited long enough are attended to. A time in the past is now.
  std::vector<Happening> advance(SimTime t);

  SimTime now() const { return now_; }
  const EngineState& state() const { return *state_; }
  const Pipeline& pipeline() const { return pipeline_; }
  const EngineParts& parts() const { return parts_; }
  /// The latest instant at which waiting inputs are attended to; nothing if none waits.
  std::optional<SimTime> due() const { return pipeline_.due(*state_); }

  // The same, for callers that watch each step.

  enum class Step {
    none,    ///< nothing is left to do
    world,   ///< the world goes on
    tell,    ///< the engine receives reports of ended acts
    attend,  ///< the engine attends to a complete input
    wake,    ///< an input has waited long enough
  };
  /// Called before and after each step. Either function ends the run by returning false.
  struct Onlooker {
    std::function<bool(Step)> before;
    std::function<bool(Step, Happening)> after;
  };
  /// Takes all immediate steps and, if `t` is given, all steps until then.
  void run(std::optional<SimTime> t, const Onlooker& onlooker);
  /// The first thoughts of begin() and hear(), without their consequences.
  Thought open(Learned learned = {});
  Thought receive(const InputEvent& event);
  /// Whether the immediate consequences of the last thought have happened in the world.
  bool is_settled() const { return settled_; }

  /// Changes the engine's state by `change`, a function of its pipeline, its state and the world.
  using Change = std::function<Tick(const Pipeline&, const EngineState&, const WorldSnapshot&)>;
  Thought change(const Change& change);
  /// Goes on with other parts, from the state after `prepare`. Errors are those of Pipeline::take_over(); then nothing
  /// has changed.
  Outcome go_on_with(EngineParts parts, const std::function<void(EngineState&)>& prepare);

 private:
  Step next(std::optional<SimTime> t) const;
  Happening take(Step step, std::optional<SimTime> t);
  Thought obey(Tick tick);
  WorldReport let_world_go_on(SimTime t);
  std::vector<Happening> all(std::optional<SimTime> t, std::vector<Happening> happenings);

  EngineParts parts_;
  Body& body_;
  std::size_t most_branches_;
  Pipeline pipeline_;
  std::optional<EngineState> state_;  // set by open()
  SimTime now_;
  std::vector<ActReport> untold_;  // reports for the engine, if an act among them has ended
  bool settled_ = true;
  bool only_begun_ = false;  // the world's last report told of acts that begin, and of no end
};

}  // namespace continua
