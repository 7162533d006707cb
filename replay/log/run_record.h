// The records of a run log that describe what a run was made of: its first line (RUNLOG.md, `run`).
#pragma once

#include <map>
#include <string>

#include "continua/core/located_json.h"

namespace continua {

/// What the header of a run log says. Digests are of the files' bytes.
struct RunHeader {
  std::string continua_version;
  std::string trace_name, trace_digest;  ///< no digest: the trace was written along with the run
  std::uint64_t seed = 0;
  std::string choice, world, perspective;
  std::string variant;                ///< how what was observed was followed; empty: not
  Json parameters;                    ///< of the machine: {name: value}; null: it has none
  std::map<int, std::string> forced;  ///< step → id of the transition that was forced there
  std::size_t most_branches = 0;      ///< bound of the set under `explore`; 0 under other policies
  Json fingerprint;
  std::string machine_name, machine_digest;
  Json machine_document, graph;
  std::string phrases_name, phrases_digest;  ///< empty if the machine has none
  Json phrases_document;
  Json learned;                              ///< what was taught before the run; null: nothing
  std::string voxemes_digest;                ///< empty if there are none
  Json knowledge = Json::object();           ///< {path below the knowledge folder: digest} of the files it draws on
  std::string lexicon_name, lexicon_digest;  ///< empty if the machine has none
  std::string scene_name, scene_digest, scene_mjcf;
  Json scene_description;                   ///< {"geoms", "bodies"}
  std::vector<std::string> without_voxeme;  ///< objects of the scene of which nothing is known
};

/// The fields of the `run` record.
Json run_fields(const RunHeader& header);

}  // namespace continua
