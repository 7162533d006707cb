#include "continua/replay/log/run_meaning.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "continua/core/digest.h"
#include "continua/core/result.h"
#include "continua/replay/log/line_scan.h"

namespace continua {
namespace {

using Names = std::vector<std::string_view>;

// What is to be done with members of these names. Of a log's million records each is looked up: by a table of their
// lengths and first bytes.
template <class Use>
class Members {
 public:
  void add(std::string_view name, Use use) {
    require(uses_.size() < places_.size() / 2, "a table has room for its names");
    auto at = place_of(name);
    while (places_[at]) at = (at + 1) % places_.size();
    uses_.emplace_back(name, use);
    places_[at] = static_cast<std::uint8_t>(uses_.size());
  }
  Use find(std::string_view name, Use otherwise) const {
    for (auto at = place_of(name); places_[at]; at = (at + 1) % places_.size())
      if (const auto& [known, use] = uses_[places_[at] - 1U]; known == name) return use;
    return otherwise;
  }

 private:
  static std::size_t place_of(std::string_view name) {
    std::uint64_t head = name.size();
    for (std::size_t i = 0; i < std::min<std::size_t>(name.size(), 7); ++i)
      head = (head << 8) | static_cast<unsigned char>(name[i]);
    return (head * 0x9E3779B97F4A7C15ULL) >> 57;
  }

  std::vector<std::pair<std::string_view, Use>> uses_;
  std::array<std::uint8_t, 128> places_{};
};

enum class Use : std::uint8_t { what, walked_what, rest, walked_rest, none };

// Members that tell where a record stands in its log, or how near and by which way it was decided.
const Names of_place{"kind",     "n",      "t",       "cause",    "because", "line",  "step",
                     "measured", "margin", "weights", "resolved", "entries", "rules", "id",
                     "below",    "stack",  "act",     "result",   "waited_s"};

}  // namespace

struct RecordKind {
  /// `what`: members that tell what happened; `left_out`: members that do not count in those that are `walked`.
  RecordKind(std::string_view of, const Names& what, const Names& out = {}, const Names& walked = {}) : name(of) {
    const auto is_among = [](std::string_view one, const Names& names) {
      return std::find(names.begin(), names.end(), one) != names.end();
    };
    for (const auto one : what) uses.add(one, is_among(one, walked) ? Use::walked_what : Use::what);
    for (const auto one : walked)
      if (!is_among(one, what)) uses.add(one, Use::walked_rest);
    for (const auto one : of_place)
      if (!is_among(one, what) && !is_among(one, walked)) uses.add(one, Use::none);
    for (const auto one : out) left_out.add(one, true);
  }

  std::string_view name;
  Members<Use> uses;
  Members<bool> left_out;
};

namespace {

// A transition's id is its machine's, every other the log's.
const std::vector<RecordKind> kinds{
    {"input", {"event"}, {"t", "until", "act", "row"}, {"event"}},
    {"percept", {"bound"}, {"from", "until", "spread_m", "samples", "left_out"}, {"bound"}},
    {"reading", {"move", "words", "meaning", "referents", "taken"}},
    {"belief", {"concept", "value"}},
    {"memory", {"register", "value"}},
    {"transition", {"id", "from", "to", "input"}, {"reason"}, {"refused"}},
    {"correction", {"from", "to"}},
    {"symbol", {"slots"}},
    {"rewrite", {"state"}},
    {"application", {"function", "argument", "result"}},
    {"utterance", {"text"}},
    {"gesture", {"gesture"}},
    {"learned", {"of", "name", "value"}},
    {"forgotten", {"of", "name", "value"}},
    {"act", {"program", "status"}},
    {"refusal", {"state", "input"}, {"reason"}, {"refused"}},
    {"observed", {"channel", "content"}},
    {"expect", {"expected"}},
    {"branches", {"branches"}, {"id", "parent", "stack", "dropped"}, {"branches", "dropped"}},
    {"pose", {"bodies"}},
};

// The value without members of these names.
void add_walked(std::string_view value, const Members<bool>& left_out, std::string& text) {
  if (value.starts_with('{')) {
    text += '{';
    scan_members(value, [&](std::string_view key, std::string_view member) {
      if (left_out.find(key, false)) return;
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

const RecordKind* record_kind(std::string_view name) {
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const RecordKind& one) { return one.name == name; });
  return found == kinds.end() ? nullptr : &*found;
}

RecordMeaning meaning_of(const RecordKind* kind, std::span<const RecordMember> members) {
  if (!kind) return {};
  thread_local std::string what, rest;
  what.assign(kind->name).append(" ");
  rest.clear();
  for (const auto& [key, value] : members) {
    const auto use = kind->uses.find(key, Use::rest);
    if (use == Use::none) continue;
    auto& text = use == Use::what || use == Use::walked_what ? what : rest;
    text.append(key).append(":");
    if (use == Use::walked_what || use == Use::walked_rest)
      add_walked(value, kind->left_out, text);
    else
      text.append(value);
    text += ',';
  }
  const auto happened = hash_of(what);
  return {happened, rest.empty() ? happened : hash_of(what += rest)};
}

std::uint64_t meaning_of_event(std::string_view event) {
  std::string text;
  add_walked(event, record_kind("input")->left_out, text);
  return hash_of(text);
}

}  // namespace continua
