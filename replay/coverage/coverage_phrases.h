// The cases of a machine's phrases that were said, as far as a run log tells. An utterance belongs to the phrases that
// its transition, or the state that this led to, can say; among their cases, to the one whose text it fits best.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "continua/core/located_json.h"

namespace continua {

struct CoverageKind;

/// How much of `text` a template's own text makes up, in bytes: the parts in braces can be anything. Nothing if the
/// template cannot have given the text.
std::optional<std::size_t> fit_of(std::string_view pattern, std::string_view text);

class PhraseCounts {
 public:
  /// `machine` and `phrases` in the form of a log's header (RUNLOG.md), with their documents. Only phrases that the
  /// machine uses count.
  PhraseCounts(const Json& machine, const Json& phrases);

  /// Said by a transition and the state it led to. Cases that it fits equally well are all counted.
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
