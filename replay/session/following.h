// How a run follows another avatar's observed moves (Variant): its acts move the world, and where it did something else
// than the engine, the dialogue goes on from there.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "continua/behaviour/reenactment.h"
#include "continua/pipeline/pipeline.h"
#include "continua/replay/score/episodes.h"
#include "continua/replay/session/session.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

class Following {
 public:
  /// Observed moves are terms of the machine's programs over the world's objects. `catalogue`, of voxemes, may be null
  /// and must outlive it.
  Following(Variant variant, bool at_once, const WorldSnapshot& world, const Machine& machine,
            const Catalogue* catalogue, Perspective perspective);

  /// An input is about to be received.
  void begin(const EngineState& state, const InputEvent& event) { before_.emplace(Before{state, event}); }
  /// Whether nothing more is observed of the last input when time goes on, or only another input ends it.
  bool at_once() const { return at_once_; }

  /// Once for each input, when all that was observed of it is known: carries out the observed acts. Returns whether
  /// they or the engine's own may have moved anything, so that its world is to become world().
  bool end(const Episode& episode, SimTime t);
  const KinematicBody& world() const { return world_.body(); }

  /// The engine's answer to the input last ended differs from the observed one, and the engine is to go on from the
  /// latter.
  bool is_corrected() const { return corrected_; }
  /// REQUIRES is_corrected().
  Tick correct(const Pipeline& pipeline, const EngineState& after, const WorldSnapshot& world) const;

 private:
  struct Before {
    EngineState state;
    InputEvent event;
  };

  ObservedMoves moves_of(const Episode& episode) const;
  Term term_of(const std::string& content) const;

  Variant variant_;
  bool at_once_;
  Blanks blanks_;
  Signature names_;  ///< that observed moves are made of
  Reenactment world_;
  std::optional<Before> before_;
  ObservedMoves observed_;
  bool corrected_ = false;
};

}  // namespace continua
