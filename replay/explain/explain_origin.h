// Where a value of a run came from: a word, a gesture, a pointing, what was taught, or the machine itself.
#pragma once

#include <string>
#include <string_view>

#include "continua/replay/explain/explain_scope.h"

namespace continua {

/// The origin of the value that record `at` has, as
/// {"kind": `words`, `pointing`, `gesture`, `choice`, `open`, `taught`, `memory`, `slot` or `machine`;
///  "text": the origin for people; "n": the record that tells; "input": n of the input that it goes back to, or null;
///  "t": that input's seconds, or null; "words", "by" (as in RUNLOG.md) of what words resolve to;
///  "from": where that has it from, an origin again; left out where there is nothing before}.
Json origin_of(ExplainScope& scope, const std::string& value, std::size_t at);

/// "“Put it there.” (4.0 s)"; of an n-best list what was gone on with: "“Put it there.” (4.0 s, alternative 1)".
std::string told_input(ExplainScope& scope, std::size_t input);

/// How a reading came by what a phrase means (`by`), in words: "what was talked about"; empty for its own words.
std::string way_text(const std::string& by);

/// Whether one of a reading's `entries` is of the parse that was gone on with.
bool is_of_reading(const Json& entry, const Json& reading);

/// "a", "a or b", "a, b or c"; of more than `most` the first, and how many there are.
std::string alternatives_text(const Json& names, std::string_view before_last = " or ", std::size_t most = 6);

/// What a gap of a reading (an element of `missing`) says: "it was not said", "“block” may mean block1 or block4".
std::string missing_text(const Json& missing);

}  // namespace continua
