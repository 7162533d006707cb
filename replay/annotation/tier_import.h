// Annotations as a trace.
#pragma once

#include "continua/core/result.h"
#include "continua/replay/annotation/tier_map.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// The trace of these annotations. One that an export made and nobody has changed gives back its event; one that was
/// moved, its event at another time; one with another label counts as annotated by hand. Annotations that cannot be
/// used are left out with a note. Errors: the header or the map makes no trace, or no annotation can be used.
Result<Trace> trace_of_annotations(const Annotations& annotations, const TierMap& map);

}  // namespace continua
