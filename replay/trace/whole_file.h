// Files written in one go.
#pragma once

#include <string>
#include <string_view>

#include "continua/core/result.h"

namespace continua {

/// Error: it cannot be written, and why.
Outcome write_whole_file(const std::string& path, std::string_view content);

}  // namespace continua
