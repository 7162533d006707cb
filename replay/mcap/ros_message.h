// Messages of ROS 2: their definitions as text (MCAP's schema encoding "ros2msg"), and their bytes (CDR) as JSON.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

/// A member of a message.
struct RosMember {
  enum class Many { one, exactly, list };
  std::string type, name;  ///< a basic type, or the full name of a message: "std_msgs/Header"
  Many many = Many::one;
  std::uint64_t count = 1;  ///< of Many::exactly
};

/// The definition of a message, and of those that are parts of it.
struct RosDefinition {
  std::string type;                                     ///< "hri_msgs/LiveSpeech"
  std::map<std::string, std::vector<RosMember>> types;  ///< messages by their full names
};

/// The full name of a message without "msg/": "std_msgs/msg/String" is "std_msgs/String".
std::string ros_type(std::string_view name);

/// Reads the definition of the message `type`: its own lines, then those of its parts, each after a line of "=" and
/// "MSG: TYPE". Time and Duration are known. Errors name the line: it is no member, or its type is not defined.
Result<RosDefinition> read_ros_definition(const std::string& type, std::string_view text);

/// The message as JSON. Errors: the bytes are not that message.
Result<Json> message_of_cdr(const RosDefinition& definition, std::string_view bytes);

/// The bytes of a message whose members are those of the definition. A missing one is 0 or empty.
std::string cdr_of_message(const RosDefinition& definition, const Json& message);

}  // namespace continua
