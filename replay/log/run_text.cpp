#include "continua/replay/log/run_text.h"

#include "continua/core/located_json.h"

namespace continua {

std::string text_in(std::string_view value) {
  if (is_plain_text(value)) return std::string(value.substr(1, value.size() - 2));
  if (value.empty() || value == "null") return {};
  const auto parsed = Json::parse(value, nullptr, false);
  if (parsed.is_discarded()) return std::string(value);
  return parsed.is_string() ? parsed.get<std::string>() : compact(parsed);
}

}  // namespace continua
