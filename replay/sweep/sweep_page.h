// A page about a sweep, to be opened from a disk: pictures, all points, and two of them beside each other.
#pragma once

#include <string>
#include <vector>

#include "continua/core/located_json.h"

namespace continua {

/// `lines`: the points as JSON (sweep_result.h). `folder`: the sweep's own, as commands are to name it. `pictures`: the
/// names of files beside the page.
std::string sweep_page(const std::vector<Json>& lines, const std::string& folder,
                       const std::vector<std::string>& pictures);

}  // namespace continua
