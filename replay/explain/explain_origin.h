// The source of a value of a run: a word, a gesture, a pointing, a lesson, or the machine itself.
#pragma once

#include <string>
#include <string_view>

#include "continua/replay/explain/explain_scope.h"

namespace continua {

/// The origin of the value that record `at` has, as
/// {"kind": `words`, `pointing`, `gesture`, `choice`, `open`, `taught`, `memory`, `slot` or `machine`;
///  "text": the origin for people; "n": the record that tells; "input": n of the input that it goes back to, or null;
///  "t": that input's seconds, or null; "words", "by" (as in RUNLOG.md) of the words' meaning;
///  "from": the origin of that, an origin again; left out where there is nothing before}.
Json origin_of(ExplainScope& scope, const std::string& value, std::size_t at);

/// "“Put it there.” (4.0 s)"; of an n-best list the alternative that was taken: "“Put it there.” (4.0 s, alternative
/// 1)".
std::string told_input(ExplainScope& scope, std::size_t input);

/// A reading's way to the meaning of a phrase (`by`), in words: "what was talked about"; empty for its own words.
std::string way_text(const std::string& by);

/// Whether one of a reading's `entries` is of the parse that was gone on with.
bool is_of_reading(const Json& entry, const Json& reading);

/// "a", "a or b", "a, b or c"; of more than `most` the first, and their number.
std::string alternatives_text(const Json& names, std::string_view before_last = " or ", std::size_t most = 6);

/// A gap of a reading (an element of `missing`) in words: "it was not said", "“block” may mean the red block or the
/// blue block".
std::string missing_text(const RunWords& words, const Json& missing);

}  // namespace continua
