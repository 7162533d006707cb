#include "continua/pipeline/fuse.h"

#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "continua/perception/pieces.h"
#include "continua/pipeline/perceive.h"

namespace continua {
namespace {

// Pointings farther than this from the edge of the table are not believed.
constexpr double believed_beside_m = 0.25;

EngineState with_complete(EngineState state, std::vector<Ensemble> ensembles) {
  state.complete.insert(state.complete.end(), std::make_move_iterator(ensembles.begin()),
                        std::make_move_iterator(ensembles.end()));
  return state;
}

// Pieces of one sentence: read as a whole, they say at least as much as apart.
Joining joining_of(const Engine& engine, const EngineState& state) {
  const auto understanding = understanding_of(engine, state);
  if (!understanding) return {};
  return [understanding = *understanding](const Percept& first, const Percept& second) -> std::optional<Percept> {
    Percept whole = heard(joined(first.event, second.event), second.serial, understanding);
    if (!reads_as_one(*first.readings, *second.readings, *whole.readings)) return std::nullopt;
    whole.pieces = first.pieces;
    whole.pieces.push_back(first.serial);
    return whole;
  };
}

}  // namespace

Fusion first_fusion(const Engine& engine, const WorldSnapshot& world) {
  const Vec3 margin(believed_beside_m, believed_beside_m, 0);
  return Fusion(engine.window, {world.table.min - margin, world.table.max + margin});
}

Result<EngineState> fuse(const Engine& engine, EngineState state, Percept percept, SimTime now) {
  const InputEvent event = percept.event;
  const int serial = percept.serial;
  if (!state.fusion.receive(std::move(percept), now))
    return Error{
        "", fmt::format("it came {} s late; expected within {} s", (now - event.t).seconds(), state.fusion.latest_s())};
  if (event.modality == Modality::pointing) state.fusion.sample(event, serial, now);
  // Without fusion nothing waits.
  return engine.machine->fusion ? released(engine, std::move(state), now) : released_all(engine, std::move(state));
}

EngineState released(const Engine& engine, EngineState state, SimTime now) {
  auto ensembles = state.fusion.release(now, joining_of(engine, state));
  return with_complete(std::move(state), std::move(ensembles));
}

EngineState released_all(const Engine& engine, EngineState state) {
  auto ensembles = state.fusion.release_all(joining_of(engine, state));
  return with_complete(std::move(state), std::move(ensembles));
}

Ensemble take_complete(const Engine& engine, EngineState& state) {
  Ensemble ensemble = std::move(state.complete.front());
  state.complete.erase(state.complete.begin());
  const auto understanding = understanding_of(engine, state);
  auto& percept = ensemble.percept;
  if (understanding && percept.event.modality == Modality::speech)
    percept.readings = readings_of(percept.event, *understanding, std::move(percept.readings));
  return ensemble;
}

}  // namespace continua
