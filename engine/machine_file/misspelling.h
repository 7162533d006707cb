// Names that differ by a slip of the hand.
#pragma once

#include <string_view>

namespace continua {

/// Whether one name is the other with a letter too many, too few or wrong, with two letters exchanged, or in another
/// case. Names that differ in a digit or only at an end are meant to differ; names of fewer than three bytes are too
/// short to tell.
bool is_slip(std::string_view a, std::string_view b);

}  // namespace continua
