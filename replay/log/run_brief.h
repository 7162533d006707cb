// A record in a few words, for lists and labels. Reads the log's own fields only.
#pragma once

#include <string>
#include <string_view>

#include "continua/core/located_json.h"

namespace continua {

/// The member, or null where it is missing or `object` is no object.
const Json& member_of(const Json& object, const char* key);

/// Text of a member that may be missing, null or not a string: strings without quotes, all else as JSON.
std::string text_of(const Json& object, const char* key);

/// The record in brief, without its kind, number and time. A record of a kind that this program does not know gives its
/// fields as JSON.
std::string brief(const Json& record);

}  // namespace continua
