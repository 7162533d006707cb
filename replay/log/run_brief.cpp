#include "continua/replay/log/run_brief.h"

#include "continua/replay/log/records.h"

namespace continua {

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
