// The curve of robust.h for people: a table, a picture.
#pragma once

#include <string>

#include "continua/replay/experiment/robust.h"

namespace continua {

std::string robust_text(const Robustness& robustness);

/// SVG: for each kind of noise the shares of the ends against the strength.
std::string robust_svg(const Robustness& robustness);

/// {"points": [{"kind", "strength", "runs", "same", "asks", "less", "otherwise"}], "breaks": [{"trace", "kind",
/// "strength", "changes", "acts"}]}; of ends the numbers of runs.
Json robust_json(const Robustness& robustness);

}  // namespace continua
