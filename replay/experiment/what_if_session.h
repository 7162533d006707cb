// Replays runs with changes, from their logs: scene, machine, phrases and lessons are the log's; words, gestures and
// voxemes are the program's own.
#pragma once

#include <memory>

#include "continua/replay/inspector/run_what_if.h"

namespace continua {

std::shared_ptr<RunWhatIf> replayed_what_if();

}  // namespace continua
