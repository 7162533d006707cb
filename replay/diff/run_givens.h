// The ingredients of two runs, as far as they differ: their headers (RECORDS.md, `run`) compared.
#pragma once

#include <string>
#include <vector>

#include "continua/core/located_json.h"

namespace continua {

/// One thing that the runs do not have in common.
struct GivenDifference {
  /// "machine", "phrases", "lexicon", "gestures", "raising", "voxemes", "scene", "learned", "choice", "world",
  /// "perspective", "program".
  std::string kind;
  std::string what;  ///< "transition 'ask': when", "cup", "seed"
  Json a, b;         ///< null: that run has no such thing
  std::string name;  ///< the transition, state, definition, object or file that it belongs to
};

/// The differences between two documents, part by part: members by their names, elements of arrays by their `id` or
/// `name`, else by their places. At most `most` parts.
std::vector<GivenDifference> document_differences(const std::string& kind, const Json& a, const Json& b,
                                                  std::size_t most = 100);

/// Headers are `run` records; after a change in mid-run the new values count. In the order in which they are best named
/// as a cause.
std::vector<GivenDifference> given_differences(const Json& a, const Json& b);

/// "transition 'ask': when: x = 1 in A, x = 2 in B"; without its kind.
std::string told(const GivenDifference& difference);

}  // namespace continua
