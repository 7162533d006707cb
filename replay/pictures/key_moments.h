// The instants of a run that are worth a picture each.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "continua/replay/pictures/run_story.h"

namespace continua {

/// A happening, for a caption.
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

/// The moments to show, by rule: the human's words and gestures with consequences, when they were over; the avatar's
/// words; the ends of acts and of the body's steps, with their outcomes. Happenings close together are one moment, in
/// which steps are told only if there is nothing else. Of more than `most` the least important are left out, of these
/// those nearest to another. In order of time; never empty.
std::vector<KeyMoment> key_moments(const RunStory& story, std::size_t most = 12);

}  // namespace continua
