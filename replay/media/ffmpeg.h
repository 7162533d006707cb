// The program ffmpeg, which knows the formats of recordings.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/result.h"

namespace continua {

/// Runs ffmpeg on the file `recording` with these words after the input, and hands on what it writes to its standard
/// output. It reads no other file, nothing of a network, and formats of recordings alone. Errors: it is not installed,
/// it cannot read the recording, or it took longer than `most_s` seconds.
Outcome run_ffmpeg(const std::string& recording, const std::vector<std::string>& words, double most_s,
                   const std::function<void(std::string_view)>& output);

}  // namespace continua
