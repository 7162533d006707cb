// Approved runs, with which the replays of traces are compared (traces/FORMAT.md, Approved runs). Reads and writes run
// logs as text; knows nothing of replays.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "continua/core/result.h"

namespace continua {

/// Runs whose logs would be longer files are approved by their digests alone; one that is approved packed stays packed.
inline constexpr std::size_t longest_approved_log = 1024 * 1024;

/// The file next to a trace that holds its approved run.
struct ApprovedRun {
  std::string path;     ///< NAME.run.jsonl, packed or not: a log; NAME.run.json: its digests
  std::string content;  ///< of a log, with the documents that are kept beside it
};

/// Else only its digests.
bool is_whole_log(const ApprovedRun& approved);

/// The approved run of a trace, NAME.trace.jsonl, in a world, "physics" or "kinematic": NAME.WORLD.run.jsonl or .json
/// where the body's deeds lead elsewhere in that world, else NAME.run.jsonl or .json; nullopt if there is none. Before
/// these, for physics, NAME.physics.mujoco-VERSION.run.jsonl or .json of the version `mujoco`. An error if it cannot be
/// read or there are two of these.
Result<std::optional<ApprovedRun>> find_approved_run(const std::string& trace_path, const std::string& world,
                                                     const std::string& mujoco = "");

/// The versions of MuJoCo that a trace has approved runs of, as a part of a sentence: "MuJoCo 2.2.2, 3.12.0". Empty if
/// `approved` is of the version `mujoco`, or does not tell its own.
std::string other_mujocos(const std::string& trace_path, const ApprovedRun& approved, const std::string& mujoco);

/// The file to write to approve a run: its log, or its digests if the log is long or `before` has no more. If `before`
/// is of another world, or of the same trace by another version of MuJoCo, it stays; another path in the same world
/// takes its place (takes_place_of).
ApprovedRun approval_of(const std::string& trace_path, std::string_view run, const std::optional<ApprovedRun>& before);

/// Writes the file. Where a folder `documents` stands beside it or above, the documents of its log go there.
Outcome write_approval(const ApprovedRun& approval);

/// Whether `before` is to be removed once `approval` is written.
bool takes_place_of(const ApprovedRun& approval, const ApprovedRun& before);

enum class Sameness {
  same,            ///< every byte, apart from the ingredients of the run
  same_decisions,  ///< of another world, another machine file, …
  changed,
  stale,  ///< the approved run was made from another trace
};

struct RunComparison {
  Sameness sameness = Sameness::same;
  std::string difference;  ///< of digests, which; one line
};

/// `run`: the log of a replay. An error if the approved file is no run, or is cut short.
Result<RunComparison> compare_to_approved(std::string_view run, const ApprovedRun& approved);

}  // namespace continua
