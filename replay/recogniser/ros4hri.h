// Messages of ROS4HRI (REP 155) in JSON as events of a trace.
#pragma once

#include <optional>

#include "continua/core/located_json.h"

namespace continua {

/// Whether it is a LiveSpeech or a Gesture of hri_msgs, by its members.
bool is_ros4hri(const Json& message);

/// Its event at this time, if there is one; nothing where nobody has said anything, or the gesture is none that
/// hri_msgs names. REQUIRES is_ros4hri(message).
std::optional<Json> ros4hri_event(const Json& message, std::optional<double> t_s);

}  // namespace continua
