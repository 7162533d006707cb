// Names in traces: other ones for things, and none for people.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "continua/core/result.h"
#include "continua/replay/trace/trace_file.h"

namespace continua {

/// Names and what stands in their place, in order.
using NameTable = std::vector<std::pair<std::string, std::string>>;

/// Gives things, gestures and participants other names: in the header's `objects`, in gestures' names, in terms of what
/// was observed and is expected. Only whole names count; what people say stays. Error: two objects get one name.
Result<Trace> rename_in_trace(const Trace& trace, const NameTable& names);

/// Puts other words in the place of the table's, wherever people's words are: in speech, its words and alternatives, in
/// marks, in what was observed and is expected. A name may have several words; upper and lower case are one. The header
/// loses `recorded`, `source` and `media`, and events their `row`.
Result<Trace> anonymise_trace(const Trace& trace, const NameTable& names);

/// The table in a JSON file {NAME: REPLACEMENT}. Errors: it is none, or a name or a replacement is no text.
Result<NameTable> read_name_table(const std::string& path);

/// `text` with whole words replaced; words are letters, digits and `_`.
std::string with_words_replaced(const std::string& text, const NameTable& names, bool fold);

}  // namespace continua
