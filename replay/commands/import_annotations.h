// Annotations of ELAN and Praat as traces.
#pragma once

#include <string>

#include "continua/core/result.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// Whether the file is one of annotations, by its name.
bool is_annotation_file(const std::string& path);

/// The trace of the file by the map of tiers at `tiers`. Without a map it is guessed, and put into `guessed` as a file
/// unless an export made these tiers.
Result<Trace> import_annotations(const std::string& path, const std::string& tiers, std::string& guessed);

}  // namespace continua
