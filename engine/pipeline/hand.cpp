#include "continua/pipeline/hand.h"

#include <utility>

#include "continua/moves/discourse.h"
#include "continua/moves/inputs.h"

namespace continua {
namespace {

bool is_on(const Box& table, const Vec3& p_W) {
  return p_W.x() >= table.min.x() && p_W.x() <= table.max.x() && p_W.y() >= table.min.y() && p_W.y() <= table.max.y();
}

}  // namespace

Tick follow_hand(const Engine& engine, EngineState state, const InputEvent& sample, int serial,
                 const WorldSnapshot& world) {
  Tick tick{std::move(state), {}};
  EngineState& after = tick.after;
  if (sample.modality != Modality::pointing || !after.words.all) return tick;
  const auto place_W = place_of(sample);
  if (!place_W || !is_on(world.table, *place_W)) return tick;
  if (after.pointed && sample.t < after.pointed->t) return tick;
  const auto before = std::exchange(after.pointed, Pointed{*place_W, sample.t, ""});
  auto discourse = discourse_of(engine.stepper, after.configuration, to_input(sample, serial), facts_of(after, world));
  discourse.context.pointed_W = *place_W;
  Move move;
  move.kind = deixis;
  move.reference = refer_to_pointed(discourse.context);
  if (!move.reference.referents.empty()) after.pointed->object = move.reference.referents.front().object;
  if (before && before->object == after.pointed->object && goes_on(*before, sample.t, engine.window)) return tick;
  tick.events.push_back(Understood{std::move(move), {serial}, {}, 1, true});
  return tick;
}

}  // namespace continua
