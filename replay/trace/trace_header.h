// The first line of a trace from its text; trace_file.h is made of this.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/replay/trace/trace_file.h"

namespace continua {

/// The header that the first line that is not blank, on line `line` of `name`, has; no text: there is no such line.
/// Errors are added to `problems`; nothing where the line is not the first one of a trace of our version.
std::optional<TraceHeader> header_from_line(const std::optional<std::string_view>& text, const std::string& name,
                                            std::size_t line, std::vector<Error>& problems);

}  // namespace continua
