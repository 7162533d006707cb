// For files that other programs write, such as ffmpeg: the last step of replaced_file.h.
#pragma once

#include <string>

#include "continua/core/result.h"

namespace continua {

/// Puts the whole file `part` on the disk and in the place of `path`. Error: then `path` is as it was.
Outcome put_in_place(const std::string& part, const std::string& path);

}  // namespace continua
