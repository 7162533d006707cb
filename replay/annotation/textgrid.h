// Praat's TextGrid files.
#pragma once

#include <string>
#include <string_view>

#include "continua/core/result.h"
#include "continua/replay/annotation/annotations.h"

namespace continua {

/// The file, in Praat's long form and in UTF-8. Stretches between annotations are intervals without a label, and so are
/// annotations without one. The events of a tier are a tier of the same intervals.
std::string textgrid_of(const Annotations& annotations);

/// Whether a text begins like such a file.
bool is_textgrid(std::string_view text);

/// Reads a file in Praat's long or short form, in UTF-8 or UTF-16. Points become annotations without length. Errors: it
/// is no TextGrid, with the line, the thing found and the thing expected.
Result<Annotations> read_textgrid(std::string_view text, const std::string& name);

}  // namespace continua
