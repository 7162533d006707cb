// A conversation: the human's events go to the engine and time goes to the body's world. Both answer with happenings.
//
//   Conversation conversation(parts, body);
//   conversation.begin();
//   for (const auto& happening : conversation.hear(event)) …
//   for (const auto& happening : conversation.advance(t)) …
//
// The result does not depend on how time is cut into calls.
#pragma once

#include <functional>
#include <optional>
#include <variant>
#include <vector>

#include "continua/body/body.h"
#include "continua/knowledge_files/engine_parts.h"
#include "continua/pipeline/pipeline.h"

namespace continua {

/// The engine's events of one instant, in order; the body has got the commands among them.
struct Thought {
  SimTime t;
  std::vector<EngineEvent> events;
};

/// Thoughts, and the world's reports up to the instants at which something ended.
using Happening = std::variant<Thought, WorldReport>;

class Conversation {
 public:
  /// `body` must outlive the conversation. `most_branches`: the most configurations under `explore`.
  Conversation(EngineParts parts, Body& body, std::size_t most_branches = default_most_branches);

  /// Before anything else. `learned`: lessons of earlier conversations.
  std::vector<Happening> begin(Learned learned = {});
  /// An event of the human's at now(), and all that follows from it at once.
  std::vector<Happening> hear(const InputEvent& event);
  /// Time goes on to `t`: acts end, and inputs that waited long enough are attended to. A time in the past is now.
  std::vector<Happening> advance(SimTime t);

  SimTime now() const { return now_; }
  const EngineState& state() const { return *state_; }
  const Pipeline& pipeline() const { return pipeline_; }
  const EngineParts& parts() const { return parts_; }
  /// The instant at which waiting inputs are attended to at the latest; nothing when none waits.
  std::optional<SimTime> due() const { return pipeline_.due(*state_); }

  // The same for callers who look on while it happens.

  enum class Step {
    none,    ///< nothing more happens
    world,   ///< the world goes on
    tell,    ///< the engine is told that acts ended
    attend,  ///< the engine attends to a complete input
    wake,    ///< an input has waited long enough
  };
  /// Either ends the run by returning false.
  struct Onlooker {
    std::function<bool(Step)> before;
    std::function<bool(Step, Happening)> after;
  };
  /// Lets happen all that follows at once and, if `t` is given, all that happens until then.
  void run(std::optional<SimTime> t, const Onlooker& onlooker);
  /// The first thoughts of `begin` and `hear`.
  Thought open(Learned learned = {});
  Thought receive(const InputEvent& event);
  /// Whether all that follows at once from the last thought has happened in the world.
  bool is_settled() const { return settled_; }

  /// The engine as `change` makes it, from its pipeline, its state and the world.
  using Change = std::function<Tick(const Pipeline&, const EngineState&, const WorldSnapshot&)>;
  Thought change(const Change& change);
  /// Goes on with other parts, from the state as `prepare` leaves it. Errors as Pipeline::take_over; then nothing has
  /// changed.
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
  std::optional<EngineState> state_;  // since `open`
  SimTime now_;
  std::vector<ActReport> untold_;  // reports among which an act has ended
  bool settled_ = true;
};

}  // namespace continua
