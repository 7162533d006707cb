// The channels that an export writes: their topics, and the schemas of their messages.
#pragma once

#include <string_view>
#include <vector>

#include "continua/replay/mcap/mcap_records.h"

namespace continua {

/// A channel of messages in JSON. REQUIRES that `schema` is the name of one that we write: "continua.Event",
/// "foxglove.Log", …
McapChannel json_channel(std::string topic, std::string_view schema);

/// A channel of messages of ROS 2. REQUIRES that `type` is "hri_msgs/msg/LiveSpeech" or "std_msgs/msg/String".
McapChannel ros_channel(std::string topic, std::string_view type);

}  // namespace continua
