#include "continua/replay/log/run_meaning.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "continua/core/digest.h"
#include "continua/core/result.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/records.h"
#include "continua/replay/log/schema.h"

namespace continua {
namespace {

// The use of members by their names. Each record of a log of a million is looked up: by a table of name lengths and
// first bytes.
template <class Use>
class Members {
 public:
  void add(std::string_view name, Use use) {
    require(uses_.size() < places_.size() / 2, "a table has room for its names");
    auto at = place_of(name);
    while (places_[at] && uses_[places_[at] - 1U].first != name) at = (at + 1) % places_.size();
    if (places_[at]) return;
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

// Members within the value that do not count.
std::vector<std::string_view> left_out_of(const log::MemberSchema& member) {
  auto names = member.leaves_out;
  for (const auto& within : member.members) {
    if (!log::tells_content(within.says)) names.push_back(within.name);
    for (const auto name : left_out_of(within)) names.push_back(name);
  }
  return names;
}

}  // namespace

struct RecordKind {
  explicit RecordKind(const log::KindSchema& kind) : name(kind.kind.name) {
    uses.add("kind", Use::none);
    for (const auto& member : log::stamp_schema()) uses.add(member.name, Use::none);
    for (const auto& member : kind.members) {
      const bool counts = log::tells_content(member.says);
      const auto names = counts ? left_out_of(member) : std::vector<std::string_view>();
      for (const auto one : names) left_out.add(one, true);
      uses.add(member.name, use_of(member.says, !names.empty()));
    }
  }

  static Use use_of(log::Says says, bool walked) {
    if (!log::tells_content(says)) return Use::none;
    if (says == log::Says::what) return walked ? Use::walked_what : Use::what;
    return walked ? Use::walked_rest : Use::rest;
  }

  std::string_view name;
  Members<Use> uses;
  Members<bool> left_out;  ///< members that do not count in those that are walked
};

namespace {

// Kinds of records that tell events.
const std::vector<RecordKind>& kinds() {
  static const auto all = [] {
    std::vector<RecordKind> counted;
    for (const auto& kind : log::schema())
      if (std::any_of(kind.members.begin(), kind.members.end(),
                      [](const auto& member) { return member.says == log::Says::what; }))
        counted.emplace_back(kind);
    return counted;
  }();
  return all;
}

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
  const auto& all = kinds();
  const auto found = std::find_if(all.begin(), all.end(), [&](const RecordKind& one) { return one.name == name; });
  return found == all.end() ? nullptr : &*found;
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
  add_walked(event, record_kind(log::Input::kind.name)->left_out, text);
  return hash_of(text);
}

}  // namespace continua
