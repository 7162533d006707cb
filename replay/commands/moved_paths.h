// Paths in the header of a trace that is written to another folder.
#pragma once

#include <filesystem>
#include <string>

#include "continua/core/result.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// Makes the header's paths, which were relative to the trace at `trace`, relative to the file `output`. Names stay.
/// Error: the program's data is not there.
Outcome move_paths(TraceHeader& header, const std::string& trace, const std::string& output,
                   const std::string& knowledge = "");

/// Writes the trace, whose paths were relative to the one at `from`, to the file `output`, with paths relative to that.
Outcome write_moved(Trace trace, const std::string& from, const std::string& output, const std::string& knowledge = "");

/// Makes the paths of recordings in a trace's header, which were relative to the folder `from`, relative to `to`.
void move_media(Json& header, const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace continua
