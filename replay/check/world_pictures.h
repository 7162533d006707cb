// Pictures of the scene in two runs, for the page of a failure.
#pragma once

#include <memory>
#include <vector>

#include "continua/replay/check/check.h"
#include "continua/replay/export/run_report.h"
#include "continua/replay/scene/run_frames.h"

namespace continua {

/// The scene of both where they part, and at their ends. In the place of a picture that cannot be drawn stands why.
std::vector<WorldPictures> pictures_of(const ComparedRuns& runs, const std::shared_ptr<RunFrames>& frames);

}  // namespace continua
