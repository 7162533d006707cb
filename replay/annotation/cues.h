// Subtitles as players read them: WebVTT and SubRip.
#pragma once

#include <string>

#include "continua/replay/annotation/annotations.h"

namespace continua {

/// Words and gestures of both sides, in order of time, each with its speaker: `<v human>` in WebVTT, "human: " in
/// SubRip; gestures in brackets.
std::string vtt_of(const Annotations& annotations);
std::string srt_of(const Annotations& annotations);

}  // namespace continua
