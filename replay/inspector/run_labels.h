// Records in a few words, as many as a page shows at a time.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/core/result.h"
#include "continua/replay/log/run_index.h"
#include "continua/replay/log/run_words.h"

namespace continua {

/// brief() of the record in this line, whose kind is known; empty for poses and for a line that is no JSON.
std::string label_of(const std::string& kind, std::string_view line);

/// The same in words (brief_in_words.h).
std::string label_in_words(const RunWords& words, const std::string& kind, std::string_view line);

/// {"labels": {"N": [LABEL, TEXT, IN_WORDS, REASON], …}} of these records: the label; the text for a lane or a bubble
/// of the dialogue: the words; the gesture, the act's program in words (run_words.h); the observed content; else "";
/// the label in words where these differ, else null; the reason why an act went otherwise, in words, where there is
/// one. REQUIRES that the numbers are in order and below run.size().
Result<Json> run_labels(const RunIndex& run, const std::vector<std::size_t>& numbers);

}  // namespace continua
