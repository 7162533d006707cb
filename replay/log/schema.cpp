#include "continua/replay/log/schema.h"

#include <algorithm>

#include <fmt/format.h>

#include "continua/replay/log/record_json.h"
#include "continua/replay/log/records.h"

namespace continua::log {
namespace {

template <class T>
std::string type_text() {
  if constexpr (is_optional<T>)
    return type_text<typename T::value_type>();
  else if constexpr (is_or_null<T>)
    return type_text<typename T::value_type>() + " or null";
  else if constexpr (is_named<T>)
    return "object of " + type_text<typename T::value_type::second_type>();
  else if constexpr (is_list<T>)
    return "list of " + type_text<typename T::value_type>();
  else if constexpr (is_array<T>)
    return fmt::format("list of {} {}", std::tuple_size_v<T>, type_text<typename T::value_type>());
  else if constexpr (HasFields<T>)
    return "object";
  else if constexpr (std::is_same_v<T, std::string>)
    return "text";
  else if constexpr (std::is_same_v<T, bool>)
    return "boolean";
  else if constexpr (std::is_same_v<T, Json> || std::is_same_v<T, JsonText>)
    return "any";
  else
    return std::is_integral_v<T> ? "integer" : "number";
}

MemberSchema described(const Declaration& field, std::string type, bool left_out) {
  MemberSchema member{.name = field.name,
                      .type = std::move(type),
                      .left_out = left_out,
                      .says = field.says,
                      .sentence = field.sentence,
                      .form = field.form,
                      .in_brief = field.in_brief,
                      .follows = field.follows,
                      .leaves_out = {},
                      .members = {}};
  for (const auto name : field.leaves_out)
    if (!name.empty()) member.leaves_out.push_back(name);
  return member;
}

template <HasFields T>
std::vector<MemberSchema> members_of_type() {
  std::vector<MemberSchema> members;
  for_each_field<T>([&]<class Struct, class Value>(const Field<Struct, Value>& field) {
    auto& member = members.emplace_back(described(field, type_text<Value>(), is_optional<Value>));
    if constexpr (HasFields<Innermost<Value>>) member.members = members_of_type<Innermost<Value>>();
  });
  return members;
}

std::string_view name_of(Decision decision) {
  switch (decision) {
    case Decision::no:
      return "no";
    case Decision::yes:
      return "yes";
    case Decision::outcome:
      return "outcome";
  }
  return "no";
}

Json json_of(const std::vector<MemberSchema>& members) {
  Json all = Json::array();
  for (const auto& member : members) {
    Json one{{"name", member.name},
             {"type", member.type},
             {"optional", member.left_out},
             {"says", name_of(member.says)},
             {"meaning", member.sentence}};
    if (!member.form.empty()) one["form"] = member.form;
    if (!member.members.empty()) one["members"] = json_of(member.members);
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

const std::vector<KindSchema>& schema() {
  static const auto all = [] {
    std::vector<KindSchema> kinds;
    for_each_kind([&]<class T>() { kinds.push_back({T::kind, members_of_type<T>()}); });
    return kinds;
  }();
  return all;
}

const KindSchema* schema_of(std::string_view kind) {
  const auto& all = schema();
  const auto found = std::find_if(all.begin(), all.end(), [&](const KindSchema& one) { return one.kind.name == kind; });
  return found == all.end() ? nullptr : &*found;
}

const std::vector<MemberSchema>& stamp_schema() {
  static const auto members = members_of_type<Stamp>();
  return members;
}

Json schema_json() {
  Json kinds = Json::array();
  for (const auto& one : schema())
    kinds.push_back({{"name", one.kind.name},
                     {"when", one.kind.when},
                     {"decision", name_of(one.kind.decision)},
                     {"members", json_of(one.members)}});
  return {{"stamp", json_of(stamp_schema())}, {"kinds", std::move(kinds)}};
}

std::string_view name_of(Says says) {
  switch (says) {
    case Says::what:
      return "what";
    case Says::how:
      return "how";
    case Says::where:
      return "where";
    case Says::aside:
      return "aside";
  }
  return "what";
}

}  // namespace continua::log
