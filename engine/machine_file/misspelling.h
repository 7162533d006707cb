// Finds names that differ by a typing error.
#pragma once

#include <string_view>

namespace continua {

/// Whether one name is the other with a letter too many, too few or wrong, with two letters exchanged, or in another
/// case. False for names that differ in a digit or only at an end, which is taken as intended, and for names of fewer
/// than three bytes, which are too short to tell.
bool is_slip(std::string_view a, std::string_view b);

}  // namespace continua
