// Cells of tables of comma-separated values (RFC 4180).
#pragma once

#include <ostream>
#include <string_view>

#include "continua/core/located_json.h"

namespace continua {

/// The text, in quotes where it has to be.
void write_cell(std::string_view text, std::ostream& out);

/// Nothing for null, a text as it is, all else as JSON.
void write_value(const Json& value, std::ostream& out);

}  // namespace continua
