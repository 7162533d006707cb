// A record in a few words, for lists and labels. Reads the log's own fields only.
#pragma once

#include <string>
#include <string_view>

#include "continua/core/located_json.h"

namespace continua {

/// The member, or null where there is none or `object` is no object.
const Json& member_of(const Json& object, const char* key);

/// Text of a member that may be missing, null or not a string: strings without quotes, all else as JSON.
std::string text_of(const Json& object, const char* key);

/// What the record says, without its kind, number and time. Kinds that this program does not know give their fields as
/// JSON.
std::string brief(const Json& record);

}  // namespace continua
