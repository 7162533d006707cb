// When something was recorded, by the clock of the place, as text.
#pragma once

#include <string_view>

namespace continua {

/// Whether the text is a time like 2018-02-05, 2018-02-05T13:53 or 2018-02-05T13:53:17, of a month, day and hour that
/// there may be. As texts they are in order of time.
bool is_local_time(std::string_view text);

/// The form of such a text, for sentences.
inline constexpr const char* local_time_wanted = "a time like 2018-02-05T13:53:17";

}  // namespace continua
