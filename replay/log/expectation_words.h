// An expectation of a log as people read it: field by field, what was expected and what was found.
#pragma once

#include <string>
#include <vector>

#include "continua/core/located_json.h"
#include "continua/replay/log/run_words.h"

namespace continua {

struct ToldField {
  std::string name;                     ///< "the avatar says"
  std::string expected, found;          ///< in words: “Okay.”
  std::string raw_expected, raw_found;  ///< as the log has them, as JSON with the field's own name
  bool met = true;
};

/// The fields of an `expect` record, in their order.
std::vector<ToldField> told_fields(const RunWords& words, const Json& expect);

/// The fields of an expectation, in words: "the state Ask; the avatar says “Which block?”".
std::string wanted_text(const RunWords& words, const Json& expected);

/// The fields of an `expect` record, of an unmet one those that differ: "the avatar says “Okay.”, found “Why?”".
std::string differences_text(const RunWords& words, const Json& expect);

/// The same with the verdict before it: "not met: the avatar says “Okay.”, found “Why?”".
std::string expectation_text(const RunWords& words, const Json& expect);

}  // namespace continua
