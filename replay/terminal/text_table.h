// Tables of text, in columns.
#pragma once

#include <string>
#include <vector>

namespace continua {

using TextRow = std::vector<std::string>;
using TextTable = std::vector<TextRow>;  ///< the first row is the head; all have as many cells

/// The first column to the left, the others to the right.
std::string aligned(const TextTable& table);

}  // namespace continua
