#include "continua/replay/trace/trace_fields.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

namespace continua {
namespace {

// A value for a sentence: its type if it is large, else itself.
std::string shown(const Json& value) {
  if (value.is_array() && value.size() > 3) return fmt::format("an array of {}", value.size());
  if (value.is_object()) return "an object";
  if (value.is_string()) return in_quotes(value.get_ref<const std::string&>());
  return compact(value);
}

bool is_number_within(const Json& value, double least, double most) {
  if (!value.is_number()) return false;
  const auto number = value.get<double>();
  return number >= least && number <= most;
}

}  // namespace

const Json* TraceFields::find(const char* name) const {
  const auto found = object_.find(name);
  return found == object_.end() ? nullptr : &*found;
}

void TraceFields::need(std::initializer_list<const char*> names) const {
  if (std::any_of(names.begin(), names.end(), [&](const char* name) { return has(name); })) return;
  std::string sentence = what_ + " has no ";
  std::vector<std::string> missing(names.begin(), names.end());
  for (std::size_t i = 0; i < missing.size(); ++i) sentence += (i ? " or '" : "'") + missing[i] + "'";
  // A field that is there under nearly the same name is most likely the one that is meant.
  for (const auto& [key, value] : object_.items())
    if (const auto hint = did_you_mean(key, missing); !hint.empty()) {
      sentence += fmt::format("; found {}{}", in_quotes(key), hint);
      break;
    }
  problem(sentence);
}

std::string TraceFields::text(const char* name) const {
  const Json* value = find(name);
  if (!value) return {};
  if (value->is_string()) return value->get<std::string>();
  wrong(name, "a text");
  return {};
}

std::string TraceFields::choice(const char* name, const std::vector<std::string>& choices) const {
  const Json* value = find(name);
  if (!value) return {};
  std::string found = value->is_string() ? value->get<std::string>() : std::string();
  if (std::find(choices.begin(), choices.end(), found) != choices.end()) return found;
  std::string expected;
  for (std::size_t i = 0; i < choices.size(); ++i)
    expected += (i == 0 ? "'" : i + 1 == choices.size() ? " or '" : ", '") + choices[i] + "'";
  wrong(name, expected + did_you_mean(found, choices));
  return {};
}

bool TraceFields::truth(const char* name, bool otherwise) const {
  const Json* value = find(name);
  if (!value) return otherwise;
  if (value->is_boolean()) return value->get<bool>();
  wrong(name, "true or false");
  return otherwise;
}

std::optional<double> TraceFields::number(const char* name, double least, double most) const {
  const Json* value = find(name);
  if (!value) return std::nullopt;
  if (is_number_within(*value, least, most)) return value->get<double>();
  wrong(name, fmt::format("a number from {} to {}", least, most));
  return std::nullopt;
}

std::optional<std::uint64_t> TraceFields::whole_number(const char* name, std::uint64_t most) const {
  const Json* value = find(name);
  if (!value) return std::nullopt;
  // A number that a program made may be of a signed type, and is none the worse for it.
  const bool whole = value->is_number_unsigned() || (value->is_number_integer() && value->get<std::int64_t>() >= 0);
  if (whole && value->get<std::uint64_t>() <= most) return value->get<std::uint64_t>();
  wrong(name, fmt::format("a whole number from 0 to {}", most));
  return std::nullopt;
}

std::optional<Vec3> TraceFields::vector(const char* name, int size, double most) const {
  const Json* value = find(name);
  if (!value) return std::nullopt;
  const bool right = value->is_array() && value->size() == static_cast<std::size_t>(size) &&
                     std::all_of(value->begin(), value->end(),
                                 [&](const Json& element) { return is_number_within(element, -most, most); });
  if (!right) {
    wrong(name, fmt::format("{} in metres, each from {} to {}", size == 2 ? "[x, y]" : "[x, y, z]", -most, most));
    return std::nullopt;
  }
  return Vec3((*value)[0].get<double>(), (*value)[1].get<double>(), size == 2 ? 0 : (*value)[2].get<double>());
}

std::vector<double> TraceFields::numbers(const char* name) const {
  const Json* value = find(name);
  if (!value) return {};
  const bool right = value->is_array() && !value->empty() &&
                     std::all_of(value->begin(), value->end(),
                                 [](const Json& one) { return one.is_number() && std::isfinite(one.get<double>()); });
  if (right) return value->get<std::vector<double>>();
  wrong(name, "an array of one number or more, each finite");
  return {};
}

const Json* TraceFields::array_of_objects(const char* name) const {
  const Json* value = find(name);
  if (!value) return nullptr;
  if (value->is_array() &&
      std::all_of(value->begin(), value->end(), [](const Json& element) { return element.is_object(); }))
    return value;
  wrong(name, "an array of objects");
  return nullptr;
}

void TraceFields::problem(const std::string& sentence) const { problems_.push_back({where_, sentence}); }

void TraceFields::wrong(const char* name, const std::string& expected) const {
  const Json* value = find(name);
  problem(fmt::format("'{}' of {} is {}; expected {}", name, what_, value ? shown(*value) : "missing", expected));
}

}  // namespace continua
