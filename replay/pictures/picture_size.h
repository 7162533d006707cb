// The size of a picture as people write it.
#pragma once

#include <string_view>

#include "continua/core/result.h"
#include "continua/simulation/renderer.h"

namespace continua {

/// "640x360": width by height in pixels. The error names the expected form.
Result<ImageSize> picture_size(std::string_view text);

}  // namespace continua
