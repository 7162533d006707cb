// The recordings that go with a run: those of its trace.
#pragma once

#include <string>
#include <vector>

#include "continua/replay/log/run_index.h"
#include "continua/replay/media/media_file.h"

namespace continua {

struct RunMedia {
  std::vector<MediaFile> files;
  std::string folder;  ///< of the trace: the files' paths start here
  std::string within;  ///< the folder that none of them may lie outside of
};

/// A folder with a trace may be there, and the folder around it that paths may not leave.
struct TracePlace {
  std::string folder, within;
};

/// The recordings that the header of the run's trace names: the file of the name that the log gives, packed or not, in
/// the first of these places that has it. None where no place has it.
RunMedia media_of_run(const RunIndex& run, const std::vector<TracePlace>& places);

}  // namespace continua
