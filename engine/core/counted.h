// Numbers of things in sentences.
#pragma once

#include <cstddef>
#include <string>

namespace continua {

/// "1 event", "2 events".
std::string counted(std::size_t count, const std::string& noun);

}  // namespace continua
