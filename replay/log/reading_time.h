// The time for which words are shown where nothing tells when they ended: in subtitles, in annotations.
#pragma once

#include <string_view>

#include "continua/core/sim_time.h"

namespace continua {

/// A second to notice it, and 17 characters a second: the rule of makers of subtitles.
inline SimTime reading_time(std::string_view text) {
  return {1'000'000 + static_cast<std::int64_t>(text.size()) * 1'000'000 / 17};
}

/// Gestures are short.
inline constexpr SimTime gesture_time{1'500'000};

/// A frame of a film: instants that only have to be seen.
inline constexpr SimTime frame_time{40'000};

}  // namespace continua
