// Times of recordings as texts, by the local clock.
#pragma once

#include <string_view>

namespace continua {

/// Whether the text is a time like 2018-02-05, 2018-02-05T13:53 or 2018-02-05T13:53:17, with a possible month, day and
/// hour. The order of such texts is the order of time.
bool is_local_time(std::string_view text);

/// The expected form, for messages.
inline constexpr const char* local_time_wanted = "a time like 2018-02-05T13:53:17";

}  // namespace continua
