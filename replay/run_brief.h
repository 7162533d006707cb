// A record in a few words, for lists and labels. Reads the log's own fields only.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/located_json.h"

namespace continua {

/// The member, or null where there is none or `object` is no object.
const Json& member_of(const Json& object, const char* key);

/// Text of a member that may be missing, null or not a string: strings without quotes, all else as JSON.
std::string text_of(const Json& object, const char* key);

/// What the record says, without its kind, number and time. Kinds it does not know give their fields as JSON.
std::string brief(const Json& record);

/// The members of records of this kind that brief() reads, besides `kind`; nullptr: all of them.
const std::vector<std::string_view>* brief_members(std::string_view kind);

/// All words of letters that brief() adds to what a record says.
extern const std::string brief_words;

}  // namespace continua
