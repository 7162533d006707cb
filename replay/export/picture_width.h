// The width that a picture is made for.
#pragma once

#include <string>

#include "continua/core/result.h"

namespace continua {

/// Millimetres, a part of a page of A4 between its margins.
inline constexpr double page_width_mm = 170;

/// "85", "85mm", "8.5cm", "320px" and "240pt" in millimetres; a pixel is 1/96 inch, a point 1/72. Errors: it is no
/// length, or not from 40 to 2000 mm.
Result<double> picture_width(const std::string& text, const std::string& where);

}  // namespace continua
