// The parts of a run log (RUNLOG.md) that a picture can show: words and gestures with their speakers and times,
// pointing, acts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "continua/core/result.h"
#include "continua/core/sim_time.h"
#include "continua/replay/log/run_index.h"
#include "continua/world/geometry.h"

namespace continua {

enum class Speaker { human, avatar };

/// Something said, or, in brackets, a gesture.
struct StoryLine {
  Speaker speaker = Speaker::human;
  std::string text;
  SimTime from{}, until{};
  bool gesture = false;
  bool effective = true;  ///< something came of it
};

/// Somebody points, and where the finger is from when on.
struct StoryPointing {
  struct Sample {
    SimTime t{};
    Vec3 target_W = Vec3::Zero();
    std::optional<Vec3> from_W = {};  ///< of the ray, where the log has one
  };
  Speaker speaker = Speaker::human;
  SimTime from{}, until{};
  std::vector<Sample> samples = {};  ///< at least one, in order of time
  std::string hand = {};             ///< the human's, "left" or "right"; empty: not known
  std::string on_body = {};          ///< the avatar's: the body it points at, if it is one
  bool effective = true;
};

/// An act, or a step that the body did, came to its end.
struct StoryDeed {
  SimTime t{};
  std::string program, status, reason;
  bool step = false;
};

/// From `t` on, until the next of its kind.
struct StoryState {
  SimTime t{};
  std::string text;
};

/// Each list in order of time.
struct RunStory {
  std::vector<StoryLine> lines;
  std::vector<StoryPointing> pointings;
  std::vector<StoryDeed> deeds;
  std::vector<StoryState> states;  ///< of the machine
  std::vector<StoryState> doing;   ///< the program of the act that goes on; empty: none
  SimTime end{};
};

/// Reads the story out of the log. Errors: a record cannot be read.
Result<RunStory> read_story(const RunIndex& run);

/// The last of `states` that begins at or before `t`; empty before the first.
std::string state_at(const std::vector<StoryState>& states, SimTime t);

}  // namespace continua
