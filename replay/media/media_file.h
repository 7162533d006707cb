// Recordings of an interaction: a trace's header names them (`media`, traces/FORMAT.md), and they lie beside the trace.
#pragma once

#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

struct MediaFile {
  std::string file;  ///< as the header has it: a path relative to the trace
  std::string kind;  ///< "video", "audio", or empty where neither header nor name tells
  std::string label;
  double offset_s = 0;  ///< time of the recording when that of the trace is 0
};

/// The recordings that a trace's header names; those without a file are left out.
std::vector<MediaFile> media_in(const Json& header);

/// The media type ("video/webm") that the ending of the name tells; empty: it is not that of a recording.
std::string media_type(const std::string& file);

/// Where the recording `file` of a trace in `folder` is, with all links followed. Errors: the name is not that of a
/// recording, there is no such file, or it lies outside of the folder `within`, by its path or by a link.
Result<std::string> find_media(const std::string& file, const std::string& folder, const std::string& within);

}  // namespace continua
