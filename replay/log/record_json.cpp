#include "continua/replay/log/record_json.h"

namespace continua::log {

void put(Json::object_t& object, std::string_view name, Json value) {
  object.emplace_back(std::string(name), std::move(value));
}

const Json* find_member(const Json& object, std::string_view name) {
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

Error unexpected(std::string_view expected, const Json& found) {
  return {"", fmt::format("expected {}, found {}", expected, in_quotes(compact(found)))};
}

Outcome within_member(std::string_view name, Outcome problem) {
  if (problem) problem->where = fmt::format(".{}{}", name, problem->where);
  return problem;
}

Outcome within_element(std::size_t index, Outcome problem) {
  if (problem) problem->where = fmt::format("[{}]{}", index, problem->where);
  return problem;
}

}  // namespace continua::log
