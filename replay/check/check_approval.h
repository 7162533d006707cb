// Approving runs: asked for on the terminal, then written next to their traces.
#pragma once

#include <vector>

#include "continua/replay/check/checking.h"

namespace continua {

/// Shows the runs to be approved, each with the first lines of its diff, asks unless `options.yes`, and writes. The
/// cases whose runs are approved then hold. Nothing is approved on any other answer than y or yes; where nobody can be
/// asked it is an error.
Outcome approve(const CheckOptions& options, const std::vector<CheckItem>& items, const Checking& checking,
                std::vector<CheckCase>& cases);

}  // namespace continua
