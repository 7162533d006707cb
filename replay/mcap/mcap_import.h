// MCAP files as traces (MCAP.md): our own exports, and bags of ROS 2 with ROS4HRI's messages.
#pragma once

#include <istream>
#include <string>

#include "continua/core/result.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// The trace of the file called `name`. Its channels of "continua.Event" make the trace; where it has none, the speech
/// and gestures of hri_msgs do, and the transforms of people, in which `world` is the frame W. Channels that cannot be
/// read are left out with a note. Errors: the file is no whole MCAP file, a message is not as its schema says, an event
/// is none of a trace, or there is none; with the byte in the file where it is one's fault.
Result<Trace> trace_of_mcap(std::istream& in, const std::string& name, const std::string& world);

}  // namespace continua
