// How loud a recording is when: the waveform that a timeline draws. Kept beside the recording as NAME.peaks.json,
// {"peaks":1,"per_second":50,"values":[…]}: the largest amplitude of each stretch, 0 to 100 of the largest possible.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"

namespace continua {

/// Ending of the name of a file of peaks, after the whole name of the recording.
inline constexpr const char* peaks_ending = ".peaks.json";

/// The peaks of a recording, as its file has them: 50 a second, fewer where that would be more than 100,000. By ffmpeg.
/// Errors: those of run_ffmpeg (ffmpeg.h); it has no sound.
Result<std::string> work_out_peaks(const std::string& recording);

/// Those of the file of peaks beside the recording if it is not older, else worked out. Nothing is written.
Result<std::string> peaks_of(const std::string& recording);

/// The faults of a file of peaks.
std::vector<Error> peaks_problems(std::string_view text, const std::string& path);

}  // namespace continua
