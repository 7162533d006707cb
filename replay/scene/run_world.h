// The world of a run for a viewer: the scene, the poses of bodies, pointing and acts over time. From the log alone;
// metres and seconds, frame W.
#pragma once

#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/core/sim_time.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/log/run_words.h"
#include "continua/replay/scene/run_acts.h"
#include "continua/replay/scene/run_pointing.h"
#include "continua/replay/scene/run_poses.h"

namespace continua {

/// {"geoms":[{"body","type","size","rgba","pos","quat","mesh" where it is one}],"bodies":{NAME: pose},
/// "titles":{NAME: what people call it}} of the log's header: those of its geoms that can be drawn. Errors: the log has
/// no scene.
Result<Json> run_scene(const RunIndex& run);

/// Safe to use from several threads.
class RunWorld {
 public:
  /// Errors: a record cannot be read.
  static Result<std::shared_ptr<RunWorld>> read(std::shared_ptr<const RunIndex> run);

  /// {"from","to","start":{body: pose at `from`, as logged last},"changes":[[t,{body: pose}],…] in (from, to],
  ///  "pointing":[{"who":"human|avatar","hand","from","to","n","origin":[x,y,z]|null,"samples":[[t,x,y,z],…]}],
  ///  "acts":[{"n","act","program","told": the same in
  ///  words,"status","from","to","object":NAME|null,"target":[x,y,z]|null}]}
  /// Pointing and acts are those that overlap the window; of a pointing's samples the last before the window and those
  /// in it. A window with more than 5000 changes, samples or acts ends early, at `to`, which is then also `next`. The
  /// target of an act is the place it names or its steps measured; else the place where it put the object; else that of
  /// the body that it names as its goal.
  Json window(SimTime from, SimTime to);

 private:
  RunWorld(std::shared_ptr<const RunIndex> run, RunWords words) : poses_(std::move(run)), words_(std::move(words)) {}
  Json pointing_json(const RunPointing& pointing, SimTime from, SimTime to);
  std::optional<Point> target_of(const RunAct& act);
  std::optional<Point> place_of(const std::string& body, SimTime t);

  RunPoses poses_;
  const RunWords words_;
  std::vector<RunPointing> pointings_;
  std::vector<RunAct> acts_;
};

}  // namespace continua
