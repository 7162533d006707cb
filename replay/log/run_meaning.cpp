#include "continua/replay/log/run_meaning.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "continua/core/digest.h"
#include "continua/core/result.h"
#include "continua/replay/log/line_scan.h"
#include "continua/replay/log/record_json.h"
#include "continua/replay/log/records.h"

namespace continua {
namespace {

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

}  // namespace

struct RecordKind {
  std::string_view name;
  Members<Use> uses;
  Members<bool> left_out;  // names that do not count within members that are walked
};

namespace {

constexpr bool counts(log::Says says) { return says == log::Says::what || says == log::Says::how; }

// Notes the names that do not count in values of T, however deep; whether there are any.
template <class T>
bool leave_out(Members<bool>& names) {
  using Inner = log::Innermost<T>;
  bool any = false;
  if constexpr (log::HasFields<Inner>)
    log::for_each_field<Inner>([&]<class Struct, class Value>(const log::Field<Struct, Value>& field) {
      if (!counts(field.says)) {
        if (!names.find(field.name, false)) names.add(field.name, true);
        any = true;
      } else {
        any = leave_out<Value>(names) || any;
      }
    });
  return any;
}

// The tables of a kind of record; nothing where no member tells what happened.
template <class T>
std::optional<RecordKind> tables_of() {
  RecordKind kind{T::kind.name, {}, {}};
  bool tells = false;
  for (const auto stamp : {"kind", "n", "t", "cause", "measured"}) kind.uses.add(stamp, Use::none);
  log::for_each_field<T>([&]<class Struct, class Value>(const log::Field<Struct, Value>& field) {
    if (!counts(field.says)) return kind.uses.add(field.name, Use::none);
    bool walked = leave_out<Value>(kind.left_out);
    for (const auto name : field.leaves_out)
      if (!name.empty()) kind.left_out.add(name, true), walked = true;
    const bool what = field.says == log::Says::what;
    tells = tells || what;
    kind.uses.add(field.name, what ? (walked ? Use::walked_what : Use::what) : (walked ? Use::walked_rest : Use::rest));
  });
  return tells ? std::optional(kind) : std::nullopt;
}

const std::vector<RecordKind>& kinds() {
  static const auto all = [] {
    std::vector<RecordKind> found;
    log::for_each_kind([&]<class T>() {
      if (auto tables = tables_of<T>()) found.push_back(std::move(*tables));
    });
    return found;
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
  const auto found =
      std::find_if(kinds().begin(), kinds().end(), [&](const RecordKind& one) { return one.name == name; });
  return found == kinds().end() ? nullptr : &*found;
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
