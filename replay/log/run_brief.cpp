#include "continua/replay/log/run_brief.h"

#include <vector>

#include "continua/replay/log/records.h"

namespace continua {
namespace {

struct KindParts {
  std::string_view kind;
  std::vector<std::string_view> members;
  std::string_view adds;
};

std::vector<KindParts> parts_of_kinds() {
  std::vector<KindParts> all;
  log::for_each_kind([&]<class T>() {
    KindParts parts{T::kind.name, {}, T::kind.brief_adds};
    log::for_each_field<T>([&](const auto& field) {
      if (field.in_brief) parts.members.push_back(field.name);
    });
    all.push_back(std::move(parts));
  });
  return all;
}

}  // namespace

std::optional<BriefParts> brief_parts(std::string_view kind) {
  static const auto kinds = parts_of_kinds();
  for (const auto& parts : kinds)
    if (parts.kind == kind) return BriefParts{parts.members, parts.adds};
  return std::nullopt;
}

const Json& member_of(const Json& object, const char* key) {
  static const Json nothing;
  if (!object.is_object()) return nothing;
  const auto found = object.find(key);
  return found == object.end() ? nothing : *found;
}

std::string text_of(const Json& object, const char* key) {
  const auto& value = member_of(object, key);
  if (value.is_null()) return {};
  return value.is_string() ? value.get<std::string>() : compact(value);
}

std::string brief(const Json& record) { return log::brief(log::readable_part(record)); }

}  // namespace continua
