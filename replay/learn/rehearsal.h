// All ways in which an avatar may answer an input, tried on copies of the engine's state before the input is taken.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "continua/pipeline/pipeline.h"
#include "continua/replay/learn/estimate.h"
#include "continua/replay/score/agreement.h"

namespace continua {

/// A way with its deeds.
struct TriedWay {
  Way way;
  std::vector<AvatarMove> deeds;
  std::map<int, std::size_t> steps;  ///< step → transition of each of its picks, to force it
};

/// The tries of one input. Its words do not wait for pointing that comes later.
struct Rehearsed {
  std::vector<TriedWay> sure, unsure;  ///< `unsure` counts only with `evidence`
  std::vector<EvidenceLevel> evidence;
};

class Rehearsal {
 public:
  Rehearsal(const std::shared_ptr<const Machine>& machine, const std::shared_ptr<const Language>& language,
            Perspective perspective);

  Rehearsed rehearse(const EngineState& before, const InputEvent& event, const WorldSnapshot& world) const;

 private:
  /// The pipeline of a machine whose evidence has another worth.
  struct Variant {
    Variant(std::shared_ptr<const Machine> of_machine, const std::shared_ptr<const Language>& language,
            Perspective perspective)
        : machine(std::move(of_machine)), pipeline(machine, language, perspective) {}
    std::shared_ptr<const Machine> machine;
    Pipeline pipeline;
  };

  std::vector<TriedWay> ways(const Variant& variant, EngineState before, const InputEvent& event,
                             const WorldSnapshot& world, std::string& symbol) const;
  std::vector<EvidenceLevel> evidence_of(const std::string& symbol, const Beliefs& beliefs) const;

  Variant own_, sure_, unsure_;
};

}  // namespace continua
