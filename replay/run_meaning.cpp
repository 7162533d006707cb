#include "replay/run_meaning.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <initializer_list>
#include <string>
#include <vector>

#include "core/digest.h"
#include "core/result.h"
#include "replay/line_scan.h"

namespace continua {
namespace {

// Names of members. Of a log's million records each is looked up: by a table of their lengths and first bytes.
class Keys {
 public:
  Keys(std::initializer_list<std::string_view> names) : names_(names) {
    require(names_.size() < places_.size() / 2, "a table has room for its names");
    for (std::size_t i = 0; i < names_.size(); ++i) {
      auto at = place_of(names_[i]);
      while (places_[at]) at = (at + 1) % places_.size();
      places_[at] = static_cast<std::uint8_t>(i + 1);
    }
  }
  bool contain(std::string_view name) const {
    for (auto at = place_of(name); places_[at]; at = (at + 1) % places_.size())
      if (names_[places_[at] - 1U] == name) return true;
    return false;
  }

 private:
  static std::size_t place_of(std::string_view name) {
    std::uint64_t head = name.size();
    std::memcpy(reinterpret_cast<char*>(&head) + 1, name.data(), std::min(name.size(), sizeof head - 1));
    return (head * 0x9E3779B97F4A7C15ULL) >> 58;
  }

  std::vector<std::string_view> names_;
  std::array<std::uint8_t, 64> places_{};
};

// Members that tell where a record stands in its log, or how near and by which way it was decided.
const Keys of_place{"kind",     "n",      "t",       "cause",    "because", "line",  "step",
                    "measured", "margin", "weights", "resolved", "entries", "rules", "id",
                    "below",    "stack",  "act",     "result",   "waited_s"};

struct Kind {
  std::string_view name;
  Keys what;      ///< members that tell what happened
  Keys left_out;  ///< members that do not count, however deep they are
  Keys walked;    ///< members with such members in them
};

const std::vector<Kind> kinds{
    Kind{"input", {"event"}, {"t", "until", "act", "row"}, {"event"}},
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
      if (left_out.contain(key)) return;
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

RecordMeaning meaning_of(std::string_view kind, std::span<const RecordMember> members) {
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& one) { return one.name == kind; });
  if (found == kinds.end()) return {};
  thread_local std::string what, rest;
  what.assign(kind).append(" ");
  rest.clear();
  for (const auto& [key, value] : members) {
    // A transition's name is its machine's, every other id the log's.
    const bool happened = found->what.contain(key) || (key == "id" && kind == "transition");
    if (!happened && of_place.contain(key)) continue;
    auto& text = happened ? what : rest;
    text.append(key).append(":");
    if (found->walked.contain(key))
      add_walked(value, found->left_out, text);
    else
      text.append(value);
    text += ',';
  }
  const auto happened = hash_of(what);
  return {happened, hash_of(what += rest)};
}

std::uint64_t meaning_of_event(std::string_view event) {
  std::string text;
  add_walked(event, {"t", "until", "act", "row"}, text);
  return hash_of(text);
}

}  // namespace continua
