#include "continua/pipeline/following.h"

#include <algorithm>
#include <utility>

#include "continua/moves/discourse.h"
#include "continua/moves/inputs.h"

namespace continua {
namespace {

bool is_on(const Box& table, const Vec3& p_W) {
  return p_W.x() >= table.min.x() && p_W.x() <= table.max.x() && p_W.y() >= table.min.y() && p_W.y() <= table.max.y();
}

// The things at a place that a hand or the eyes point at.
Move shown_by(const Engine& engine, EngineState& state, const InputEvent& sample, int serial, const Vec3& place_W,
              const WorldSnapshot& world) {
  auto discourse = discourse_of(engine.stepper, state.configuration, to_input(sample, serial), facts_of(state, world));
  discourse.context.pointed_W = place_W;
  if (const auto understanding = understanding_of(engine, state); understanding && sample.modality != Modality::gaze)
    discourse.context.pointed_sd_m = understanding->pointing_sd_m(distance_of(sample));
  Move move;
  move.kind = sample.modality == Modality::gaze ? name_of(Modality::gaze) : deixis;
  move.reference = refer_to_pointed(discourse.context);
  return move;
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
  Move move = shown_by(engine, after, sample, serial, *place_W, world);
  if (!move.reference.referents.empty()) after.pointed->object = move.reference.referents.front().object;
  if (before && before->object == after.pointed->object && goes_on(*before, sample.t, engine.window)) return tick;
  tick.events.push_back(Understood{std::move(move), {serial}, {}, 1, true});
  return tick;
}

Tick follow_eyes(const Engine& engine, EngineState state, const InputEvent& sample, int serial,
                 const WorldSnapshot& world) {
  Tick tick{std::move(state), {}};
  EngineState& after = tick.after;
  if (!engine.machine->gaze || !after.words.all) return tick;
  Move move;
  if (const auto place_W = place_of(sample); place_W && is_on(world.table, *place_W))
    move = shown_by(engine, after, sample, serial, *place_W, world);
  const auto& referents = move.reference.referents;
  const bool begins = after.gaze.add({.t = sample.t,
                                      .until = sample.until.value_or(sample.t),
                                      .object = referents.empty() ? std::string() : referents.front().object,
                                      .confidence = sample.confidence,
                                      .serial = serial});
  if (begins && !referents.empty()) tick.events.push_back(Understood{std::move(move), {serial}, {}, 1, false});
  return tick;
}

Looked looked_at(const Engine& engine, const EngineState& state, SimTime now) {
  Looked looked;
  if (!engine.machine->gaze) return looked;
  std::vector<Term> objects;
  for (auto& each : state.gaze.salient(now, engine.machine->gaze->half_life_s, engine.machine->gaze->least)) {
    objects.push_back(Term::entity(each.object));
    looked.because.insert(looked.because.end(), each.serials.begin(), each.serials.end());
  }
  std::sort(looked.because.begin(), looked.because.end());
  looked.objects = Term::list(std::move(objects), Type::entity());
  return looked;
}

}  // namespace continua
