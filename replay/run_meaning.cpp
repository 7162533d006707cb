#include "replay/run_meaning.h"

#include <algorithm>
#include <string>
#include <vector>

#include "core/digest.h"
#include "replay/line_scan.h"

namespace continua {
namespace {

using Keys = std::vector<std::string_view>;

bool is_among(std::string_view key, const Keys& keys) { return std::find(keys.begin(), keys.end(), key) != keys.end(); }

// Members that tell where a record stands in its log, or how near and by which way it was decided.
const Keys of_place{"kind",    "n",        "t",       "cause", "because", "line",     "step",
                    "measured", "margin",  "weights", "resolved", "entries", "rules",
                    "id",       "below",   "stack",   "act",   "result",  "waited_s"};

struct Kind {
  std::string_view name;
  Keys what;       ///< members that tell what happened
  Keys left_out;   ///< members that do not count, however deep they are
  Keys walked;     ///< members with such members in them
};

const std::vector<Kind> kinds{
    Kind{"input", {"event"}, {"t", "until", "act"}, {"event"}},
    Kind{"percept", {"bound"}, {"from", "until", "spread_m", "samples", "left_out"}, {"bound"}},
    Kind{"reading", {"move", "words", "meaning", "referents", "taken"}, {}, {}},
    Kind{"belief", {"concept", "value"}, {}, {}},
    Kind{"memory", {"register", "value"}, {}, {}},
    Kind{"transition", {"from", "to", "input"}, {"reason"}, {"refused"}},
    Kind{"symbol", {"slots"}, {}, {}},
    Kind{"rewrite", {"state"}, {}, {}},
    Kind{"application", {"function", "argument", "result"}, {}, {}},
    Kind{"utterance", {"text"}, {}, {}},
    Kind{"gesture", {"gesture"}, {}, {}},
    Kind{"learned", {"of", "name", "value"}, {}, {}},
    Kind{"forgotten", {"of", "name", "value"}, {}, {}},
    Kind{"act", {"program", "status"}, {}, {}},
    Kind{"refusal", {"state", "input"}, {"reason"}, {"refused"}},
    Kind{"observed", {"channel", "content"}, {}, {}},
    Kind{"expect", {"expected"}, {}, {}},
    Kind{"branches", {"branches"}, {"id", "parent", "stack", "dropped"}, {"branches", "dropped"}},
    Kind{"pose", {"bodies"}, {}, {}},
};

// The value without members of these names.
void add_walked(std::string_view value, const Keys& left_out, std::string& text) {
  if (value.starts_with('{')) {
    text += '{';
    scan_members(value, [&](std::string_view key, std::string_view member) {
      if (is_among(key, left_out)) return;
      text.append(key).append(":");
      add_walked(member, left_out, text);
      text += ',';
    });
  } else if (value.starts_with('[')) {
    text += '[';
    scan_elements(value, [&](std::string_view element) {
      add_walked(element, left_out, text);
      text += ',';
    });
  } else {
    text.append(value);
  }
}

}  // namespace

RecordMeaning meaning_of(std::string_view kind, std::string_view line) {
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& one) { return one.name == kind; });
  if (found == kinds.end()) return {};
  thread_local std::string what, rest;
  what.assign(kind).append(" ");
  rest.clear();
  scan_members(line, [&](std::string_view key, std::string_view value) {
    // A transition's name is its machine's, every other id the log's.
    const bool name = key == "id" && kind == "transition";
    const bool happened = name || is_among(key, found->what);
    if (!happened && is_among(key, of_place)) return;
    auto& text = happened ? what : rest;
    text.append(key).append(":");
    if (is_among(key, found->walked))
      add_walked(value, found->left_out, text);
    else
      text.append(value);
    text += ',';
  });
  const auto happened = hash_of(what);
  return {happened, hash_of(what += rest)};
}

std::uint64_t meaning_of_event(std::string_view event) {
  std::string text;
  add_walked(event, {"t", "until", "act", "row"}, text);
  return hash_of(text);
}

}  // namespace continua
