// Which cases of a machine's phrases were said, as far as a run log tells: an utterance belongs to the phrases that its
// transition, or the state that this led to, can say; of their cases, to the one whose text it fits best.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/located_json.h"

namespace continua {

struct CoverageKind;

/// How much of `text` a template's own text makes up, in bytes: what stands in braces can be anything. Nothing if the
/// text cannot have been said by it.
std::optional<std::size_t> fit_of(std::string_view pattern, std::string_view text);

class PhraseCounts {
 public:
  /// `machine` and `phrases` as the header of a log has them (RUNLOG.md), with their documents. Of the phrases, those
  /// that the machine uses.
  PhraseCounts(const Json& machine, const Json& phrases);

  /// Said by a transition and the state it led to. Of cases that it fits equally well, all are counted.
  void said(const std::string& text, const std::string& transition, const std::string& state);

  CoverageKind reached() const;

 private:
  struct Case {
    std::string phrase, when;
    std::vector<std::string> ways;
    std::size_t count = 0;
  };
  void add_cases(const Json& phrases, const std::string& name);

  Json transitions_, states_;  ///< parts of the machine's document
  std::vector<Case> cases_;
};

}  // namespace continua
