// The instants of a run that are worth a picture each.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "continua/replay/pictures/run_story.h"

namespace continua {

/// What happened, for a caption.
struct Happening {
  std::string who;  ///< "Human", "Avatar", "Act"
  std::string text;
  SimTime began{};
  bool step = false;  ///< it is a step of an act
};

struct KeyMoment {
  SimTime t{};
  std::vector<Happening> happenings;
  int weight = 0;  ///< the more, the rather it is shown
};

/// By rule: what the human said or showed and something came of, when it was over; what the avatar said; where acts,
/// and the steps that the body did, ended, and how. What is close together is one moment, in which nothing is told of
/// steps if there is anything else. Of more than `most` the least important are left out, of these those nearest to
/// another. In order of time; never empty.
std::vector<KeyMoment> key_moments(const RunStory& story, std::size_t most = 12);

}  // namespace continua
